"""What a doubter would use in the place of a learned law: three methods that see the fitted model's residual. Needs numpy; seeds are fixed.

Each gets the motions, the forces of the analyst's fitted model and the recorded forces of the runs that are not held out, and
answers with forces of all runs. Constants are chosen by blocks held back.
"""
import numpy as np

from rigs import DT

BLOCKS = 8


def states(u, f, scale):
    """Inputs of a run between about -1 and 1: deformation, speed, simulated force, largest deformation, work, time, slow speed, rest."""
    v = np.gradient(u, DT)
    path = np.cumsum(np.abs(np.diff(u, prepend=u[0])))
    slow, late, rest = np.zeros(len(u)), 0.0, np.zeros(len(u))
    for j in range(1, len(u)):
        late += (abs(v[j]) - late) * DT / 2.0
        slow[j] = late
        rest[j] = rest[j - 1] + DT if abs(v[j]) < 1e-4 else 0.98 * rest[j - 1]
    t = np.arange(len(u)) / len(u)
    return np.column_stack([u / scale["u"], v / scale["v"], f / scale["f"], np.maximum.accumulate(np.abs(u)) / scale["u"], path / scale["path"],
                            t, slow / scale["v"], np.log1p(rest)])


def scales(motions, forces):
    v = np.concatenate([np.abs(np.gradient(u, DT)) for u in motions])
    return {"u": max(np.abs(u).max() for u in motions), "v": np.quantile(v, 0.98), "f": max(np.abs(f).max() for f in forces),
            "path": max(np.sum(np.abs(np.diff(u))) for u in motions)}


def blocks(counts):
    """Number of the fold of each sample: blocks of each run belong to four folds in turn."""
    return np.concatenate([(np.arange(n) * BLOCKS // n) % 4 for n in counts])


def chosen(options, predict, x, y, fold):
    """The option with the least error on blocks held back. predict(option, x, y, x2) gives values at x2."""
    def error(option):
        return sum(np.sum((predict(option, x[fold != k], y[fold != k], x[fold == k]) - y[fold == k]) ** 2) for k in range(4))
    return min(options, key=error)


def process(x, y, motions, fold, all_x):
    """A Gaussian process over the inputs, thinned to 500 samples, of one length and one noise."""
    step = max(1, len(y) // 500)
    x, y, fold = x[::step], y[::step], fold[::step]

    def predict(option, a, b, at):
        length, noise = option
        def kernel(p, q):
            d = (p**2).sum(1)[:, None] + (q**2).sum(1)[None, :] - 2 * p @ q.T
            return np.exp(-0.5 * np.maximum(d, 0.0) / length**2)
        return kernel(at, a) @ np.linalg.solve(kernel(a, a) + noise * np.eye(len(a)), b)
    best = chosen([(length, noise) for length in (0.2, 0.5, 1.0, 2.0) for noise in (0.01, 0.1, 1.0)], predict, x, y, fold)
    return [predict(best, x, y, at) for at in all_x]


def polynomials(x):
    """Constant, inputs, their products, and cubes of the first three."""
    n = x.shape[1]
    products = [x[:, i] * x[:, j] for i in range(n) for j in range(i, n)]
    signs = np.tanh(x[:, 1] / 0.05)
    return np.column_stack([np.ones(len(x)), x, *products, *(x[:, i] ** 3 for i in range(3)), signs, *(signs * x[:, i] for i in range(3, n))])


def sparse(x, y, motions, fold, all_x):
    """Sparse regression over products of the inputs: least squares whose small terms are struck out in turn (Brunton and others 2016)."""
    def predict(threshold, a, b, at):
        p = polynomials(a)
        norm = np.sqrt((p**2).mean(axis=0)) + 1e-12
        kept = np.ones(p.shape[1], bool)
        w = np.zeros(p.shape[1])
        for _ in range(6):
            q = p[:, kept] / norm[kept]
            w[:] = 0
            w[kept] = np.linalg.solve(q.T @ q + 1e-6 * len(b) * np.eye(kept.sum()), q.T @ b)
            found = np.abs(w) > threshold * b.std()
            if not found.any() or (found == kept).all():
                break
            kept = found
        return polynomials(at) / norm @ w
    best = chosen((0.0, 0.02, 0.05, 0.1, 0.2, 0.4), predict, x, y, fold)
    return [predict(best, x, y, at) for at in all_x]


def network(x, y, motions, fold, all_x):
    """A recurrent network of 200 units with fixed random weights; its output layer is fitted (echo state network, Jaeger 2001)."""
    rng = np.random.default_rng(7)
    inner = rng.normal(size=(200, 200)) * (rng.random((200, 200)) < 0.1)
    inner *= 0.95 / np.abs(np.linalg.eigvals(inner)).max()
    outer = rng.uniform(-1, 1, size=(200, x.shape[1]))
    leak = 10 ** rng.uniform(-2, 0, 200)

    def echoes(rows):
        s, out = np.zeros(200), np.zeros((len(rows), 200))
        for j, row in enumerate(rows):
            s = s + leak * (np.tanh(inner @ s + outer @ row) - s)
            out[j] = s
        return np.column_stack([out, rows, np.ones(len(rows))])
    all_echoes = [echoes(rows) for rows in all_x]
    fitted = np.vstack(all_echoes[:len(motions) - 1])

    def predict(ridge, a, b, at):
        return at @ np.linalg.solve(a.T @ a + ridge * len(b) * np.eye(a.shape[1]), a.T @ b)
    best = chosen(10.0 ** np.arange(-6, 2), predict, fitted, y, fold)
    return [predict(best, fitted, y, at) for at in all_echoes]


RIVALS = {"Gaussian process": process, "sparse regression": sparse, "echo state network": network}


def errors(rig):
    """Held-out NMSE of the analyst's fitted model and of each rival."""
    modelled = rig.user_forces()
    s = scales(rig.motions[:-1], modelled[:-1])
    all_x = [states(u, f, s) for u, f in zip(rig.motions, modelled)]
    residual = [y - f for y, f in zip(rig.recorded, modelled)]
    x, y = np.vstack(all_x[:-1]), np.concatenate(residual[:-1])
    fold = blocks([len(u) for u in rig.motions[:-1]])
    truth, base = rig.recorded[-1], modelled[-1]

    def nmse(v):
        return float(np.mean((truth - v) ** 2) / truth.var())
    return nmse(base), {name: nmse(base + method(x, y, rig.motions, fold, all_x)[-1]) for name, method in RIVALS.items()}
