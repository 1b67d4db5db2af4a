"""Writes the sealed cases: cases/NAME (what an analyst has), truth/NAME.json; 'make.py seal' writes sealed.sha256.
Environment: OPENSEES_TCL (the runner of Tcl scripts), GROUND_MOTIONS (folder of the recorded motions)."""
import sys, os, json, glob, hashlib, time
import numpy as np
import core as c


def registry():
    import statics_a, statics_b
    m = [statics_a, statics_b]
    try:
        import dynamics_a, dynamics_b
        m += [dynamics_a, dynamics_b]
    except ImportError as e:
        print("no dynamics:", e)
    return {f.__name__: f for x in m for f in x.CASES}


def shares(case, true):
    """objective that the analyst's best fit leaves when one effect alone is on and there is no noise, relative to each other"""
    e = {}
    keep = [r["rec"] for r in case["runs"]]
    for k in case["effects"]:
        for r in case["runs"]:
            t, o, _ = case["simulate"](r, {k})
            r["rec"] = {ch["channel"]: np.interp(r["trec"], t, o[ch["channel"]]) for ch in case["channels"]}
        e[k] = c.fit(case, true, 5)[1]
    for r, q in zip(case["runs"], keep):
        r["rec"] = q
    s = sum(e.values())
    return {k: v / s for k, v in e.items()}


def pair_nmse(case, sims, role):
    out, floor = {}, []
    for r in case["runs"]:
        if r["role"] != role:
            continue
        t = np.arange(r["set"]["npts"]) * r["set"]["dt"]
        for ch in case["channels"]:
            k = ch["channel"]
            out[r["name"], k] = c.nmse(np.interp(r["trec"], t, sims[r["name"]][k]), r["rec"][k])
            floor.append(float(np.mean(r["noise"][k] ** 2) / np.var(r["rec"][k])))
            out[r["name"], k] = (out[r["name"], k], floor[-1])
    return out, float(np.mean(floor))


def build(f):
    t0 = time.time()
    case = f()
    c.write_case(case)
    off = c.check_off(case)
    true = {n: p[0] for n, p in case["params"].items()}
    best, obj = c.fit(case, true)
    o = c.opensees(case, [best], case["runs"])[0]
    fitp, fl = pair_nmse(case, o, "fit")
    holp, hl = pair_nmse(case, o, "holdout")
    bf, bh = (float(np.mean([v[0] for v in q.values()])) for q in (fitp, holp))
    T = {"cause": case["cause"]}
    if case["cause"] == "pair":
        s = shares(case, true)
        order = sorted(s, key=lambda k: -s[k])
        T = {"cause": order[0], "also": order[1:], "effect_shares": {k: round(s[k], 3) for k in order}}
    where = {}
    if case["cause"] != "none":
        ex = {k: max(v[0] - v[1], 0) for k, v in fitp.items()}
        only = case.get("where_channels")
        if only:
            ex = {k: v for k, v in ex.items() if k[1] in only}
        top = max(ex, key=lambda k: ex[k])
        rs = [r["name"] for r in case["runs"] if r["role"] == "fit" and max(v for k, v in ex.items() if k[0] == r["name"]) >= .25 * ex[top]]
        cs = [ch["channel"] for ch in case["channels"] if max([v for k, v in ex.items() if k[1] == ch["channel"]] or [-1]) >= .25 * ex[top]]
        cs = case.get("accept_channels", cs)
        where = {"run": top[0], "channel": top[1], "accept_runs": rs, "accept_channels": cs}
        r = [r for r in case["runs"] if r["name"] == top[0]][0]
        if case.get("use_windows", True) and "mask" in r["ext"] and T["cause"] in ("gap_impact", "sensor_clipping"):
            where["windows"] = c.windows(r["tfine"], r["ext"]["mask"])
        if case.get("at"):
            where["at"] = case["at"]
    T["where"] = where
    T.update(note=case["note"], noise_floor_nmse_fit=round(fl, 7), noise_floor_nmse_holdout=round(hl, 7),
             baseline_nmse_fit=round(bf, 7), baseline_nmse_holdout=round(bh, 7),
             baseline_parameters={k: float("%.6g" % v) for k, v in best.items()}, underlying_parameters=true,
             confusable_with=case["confusable"], difficulty=case["difficulty"], ratio_fit=round(bf / fl, 2), ratio_holdout=round(bh / hl, 2),
             gap_scored=case["cause"] not in ("none", "unknown"), self_check_effect_off_nmse=float("%.3g" % off))
    os.makedirs(os.path.join(c.HERE, "truth"), exist_ok=True)
    json.dump(T, open(os.path.join(c.HERE, "truth", case["name"] + ".json"), "w"), indent=1)
    at = ["%s=%.3g" % (k, case["params"][k][0] and (best[k] - case["params"][k][1]) / (case["params"][k][2] - case["params"][k][1])) for k in best]
    pr = " ".join("%s/%s:%.2g(%.2g)" % (k[0], k[1], v[0], v[1]) for q in (fitp, holp) for k, v in q.items())
    print("%-9s %-22s off %.1e floor %.1e base %.1e ratio %.1f / %.1f  [%s] %.0fs\n     %s\n     npts %s rows %s win %s %s" % (
        case["name"], T["cause"] + "+" + "+".join(T.get("also", [])), off, fl, bf, bf / fl, bh / hl, " ".join(at), time.time() - t0, pr,
        [r["set"]["npts"] for r in case["runs"]], [r["trec"].size for r in case["runs"]], where.get("windows", "-"), T.get("effect_shares", "")), flush=True)


def seal():
    fs = sorted(glob.glob(os.path.join(c.HERE, "truth", "*.json"))) + sorted(glob.glob(os.path.join(c.HERE, "*.py")))
    with open(os.path.join(c.HERE, "sealed.sha256"), "w") as h:
        for f in fs:
            h.write("%s  %s\n" % (hashlib.sha256(open(f, "rb").read()).hexdigest(), os.path.relpath(f, c.HERE)))


if __name__ == "__main__":
    a = sys.argv[1:]
    if a == ["seal"]:
        seal()
    else:
        reg = registry()
        for n in (a or sorted(reg)):
            try:
                build(reg[n])
            except Exception as e:
                if a:
                    import traceback
                    traceback.print_exc()
                print("ERROR", n, e, flush=True)
