#!/usr/bin/env python3
"""One bearing under many sets of parameters: what a step costs in programs that can do it, in one run on the same machine.

    benches/candidates.py [--sets N]

The bearing of `calibrate.py plane` (elastomericBearingBoucWen in the plane) follows a path of 1800 steps with N sets of three parameters
(512). openseespy and OpenSeesRT (the package opensees) run the model in process, set by set, 16 of them, their force read after each step.
NumPy and JAX have nothing but the law itself, all sets side by side; JAX is compiled before it is timed. hysteron runs the script of a
study, its recorder and its objective included. Times are of the processor, in ns a step of one bearing; the largest difference of the
forces from openseespy's, over their peak, stands beside each. It needs openseespy, opensees, numpy and jax; what is missing is left out.
"""
import argparse
import importlib
import os
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import calibrate
from calibrate import BEARINGS, STEPS

OF_PEER = 16
NEWTON = 12
ETA, BETA, GAMMA = 1.0, 0.5, 0.5


def force_and_z(np_, parameters, u, du, z):
    """Force and Bouc-Wen variable after an increment of the shear deformation, by Newton's method; an axis of sets."""
    stiffness, strength, alpha = parameters
    by_yield = du * (1 - alpha) * stiffness / strength
    start = z
    for _ in range(NEWTON):
        shape = GAMMA + BETA * np_.sign(z * du)
        value = z - start - by_yield * (1 - np_.abs(z) ** ETA * shape)
        slope = 1 + by_yield * ETA * np_.sign(z) * np_.abs(z) ** (ETA - 1) * shape
        z = z - value / slope
    return strength * z + alpha * stiffness * u, z


def numpy_forces(sets, path):
    z = np.zeros(len(sets))
    forces = np.empty((STEPS, len(sets)))
    for i in range(STEPS):
        forces[i], z = force_and_z(np, sets.T, path[i + 1], path[i + 1] - path[i], z)
    return forces.T


def jax_forces():
    jax = importlib.import_module("jax")
    jax.config.update("jax_enable_x64", True)

    def one(parameters, path):
        def step(z, motion):
            force, z = force_and_z(jax.numpy, parameters, motion[0], motion[1], z)
            return z, force
        return jax.lax.scan(step, 0.0, (path[1:], path[1:] - path[:-1]))[1]

    every = jax.jit(jax.vmap(one, in_axes=(0, None)))
    return lambda sets, path: np.asarray(every(sets, path))


def peer(module):
    ops = importlib.import_module(module)
    return lambda sets, path: np.array([calibrate.peer_force(ops, "plane", p, path.tolist()) for p in sets])


def timed(run, sets, path):
    begun = time.process_time()
    forces = run(sets, path)
    return 1e9 * (time.process_time() - begun) / (STEPS * len(sets)), forces


def ours(path, recorded, threads):
    """Processor and wall time of a step, and the force at the truth."""
    with tempfile.TemporaryDirectory() as place:
        calibrate.write_study(Path(place), "plane", path.tolist(), recorded)
        result, cpu = calibrate.ours(Path(place), threads)
    wall = result["wall_s"] / result["evaluations"]
    return 1e9 * cpu / STEPS, 1e9 * wall / STEPS, result["objective"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sets", type=int, default=512)
    count = parser.parse_args().sets
    rows = BEARINGS["plane"][0]
    low, high = (np.array([r[i] for r in rows]) for i in (1, 2))
    sets = low + np.random.default_rng(1).random((count, len(rows))) * (high - low)
    path = np.array(calibrate.motion(BEARINGS["plane"][1]))
    first = sets[:OF_PEER]
    print("| program | ns a bearing-step | largest difference |\n| --- | --- | --- |")
    reference = None
    for name, module in [("openseespy", "openseespy.opensees"), ("OpenSeesRT", "opensees.openseespy")]:
        try:
            cost, forces = timed(peer(module), first, path)
        except ImportError:
            continue
        reference = forces if reference is None else reference
        print(f"| {name}, one set after the other | {cost:.0f} | {np.abs(forces - reference).max() / np.abs(reference).max():.0e} |", flush=True)
    for name, make in [("NumPy", lambda: numpy_forces), ("JAX, `vmap` and `jit`", jax_forces)]:
        try:
            run = make()
        except ImportError:
            continue
        run(sets, path)
        cost, forces = timed(run, sets, path)
        apart = np.abs(forces[:OF_PEER] - reference).max() / np.abs(reference).max()
        print(f"| {name}, {count} sets side by side | {cost:.0f} | {apart:.0e} |", flush=True)
    truth = np.array([[r[3] for r in rows]])
    recorded = peer("openseespy.opensees")(truth, path)[0]
    for threads in sorted({1, len(os.sched_getaffinity(0))}):
        cost, wall, objective = ours(path, recorded, threads)
        print(f"| hysteron, a study of 7550 sets, {threads} thread{'s' if threads > 1 else ''} | {cost:.0f} ({wall:.0f} of wall time) | "
              f"{objective ** 0.5:.0e} of the spread |", flush=True)


if __name__ == "__main__":
    sys.exit(main())
