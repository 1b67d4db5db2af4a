"""Studies: calibration, diagnosis, and the objective for any optimiser."""

import json
import tempfile
from pathlib import Path

from . import _hysteron
from ._hysteron import OpenSeesError
from ._learned import Learned
from ._written import write


class _Result:
    """Content of a result file in ``table``, and histories by run and channel."""

    def __init__(self, text, channels):
        #: The result file, as it is described in the reference of hysteron.
        self.table = json.loads(text)
        #: Recorded samples by run and channel.
        self.recorded = {}
        #: Samples of the model at the times of the recording; NaN after the end of the analysis.
        self.simulated = {}
        for run, channel, recorded, simulated in channels:
            self.recorded.setdefault(run, {})[channel] = recorded
            self.simulated.setdefault(run, {})[channel] = simulated


class Calibration(_Result):
    """Result of ``Study.calibrate``."""

    def __init__(self, text, channels, names):
        super().__init__(text, channels)
        #: Names of the free parameters.
        self.names = names

    @property
    def parameters(self):
        """Values by the names of the parameters, in the order of the study."""
        return {name: self.table["parameters"][name] for name in self.names}

    @property
    def x(self):
        """Values of the parameters as an array."""
        import numpy as np

        return np.array(list(self.parameters.values()))

    @property
    def intervals(self):
        """Intervals of 95 % of the parameters, an array of shape (parameters, 2); NaN where there are none."""
        import numpy as np

        known = {i["name"]: (i["lower"], i["upper"]) for i in (self.table.get("uncertainty") or {}).get("intervals", [])}
        return np.array([known.get(name, (np.nan, np.nan)) for name in self.names], dtype=float)

    @property
    def objective(self):
        """Mean NMSE of the fitted channels."""
        return self.table["objective"]

    def __repr__(self):
        return f"<Calibration objective={self.objective:.4g} {self.parameters}>"


class Diagnosis(_Result):
    """Result of ``Study.diagnose``."""

    def __init__(self, text, script, channels):
        super().__init__(text, channels)
        #: Text of the repaired script.
        self.script = script

    @property
    def cause(self):
        """The named cause."""
        return self.table["verdict"]["cause"]

    @property
    def confidence(self):
        """Probability of the named cause, 0 to 1."""
        return self.table["verdict"]["confidence"]

    def __repr__(self):
        return f"<Diagnosis {self.cause} ({100 * self.confidence:.0f} %)>"


class Study(_hysteron.Study):
    """A study: a script, its parameters, and the recordings that it is compared with.

    ``names``, ``bounds`` and ``initial`` describe the free parameters; ``x`` has their values in that order. With a ``client`` of
    Dask its workers evaluate, which see the files of the study under the same paths. They give the same bits.

    ``Study(file)`` reads a study. ``Study(model=function, parameters=..., runs=..., observe=...)`` makes one of a function that builds
    and analyses a model with ``hysteron.opensees`` or a ``Model``. What it calls is recorded as a script, in which the parameters stay
    free; what a script cannot say is an error. The function has the ``parameters`` and the ``inputs`` of a run as arguments:

    - ``parameters``: by name the bounds ``(lower, upper)`` or ``(lower, upper, 'log')``, a fixed number, or a dictionary with the keys of
      ``[[parameter]]`` and ``initial``. They start at the default of the function's argument, or else in the middle.
    - ``runs``: a list of ``Run``, or of its recordings alone.
    - ``observe``: by the name of a channel what the model has for it, as in ``record`` of ``analyze``: ``('disp', node, dof)``.
    - ``folder``: where the files are kept; by default a temporary folder. Other words are keys of the study, such as ``calibration``.
    """

    def __new__(
        cls, file=None, *, model=None, parameters=None, runs=None, observe=None, title=None, folder=None, compat=False, **keys
    ):
        if (file is None) == (model is None):
            raise OpenSeesError("Study: expected either the file of a study or model=function")
        kept = None
        if model is not None:
            if folder is None:
                kept = tempfile.TemporaryDirectory(prefix="hysteron-")
                folder = kept.name
            file = write(folder, model, parameters or {}, runs or [], observe or {}, title, keys)
        elif keys or parameters or runs or observe:
            wrong = next(iter({**keys, **{k: v for k, v in (("parameters", parameters), ("runs", runs), ("observe", observe)) if v}}))
            raise OpenSeesError(f"Study: {wrong} has no meaning beside the file of a study")
        self = super().__new__(cls, file, compat=compat)
        self._kept = kept
        return self

    @property
    def script(self):
        """Text of the script: of a function what it has called."""
        return (Path(self.file).parent / self._model).read_text(encoding="utf-8")

    def __reduce__(self):
        return _study, (str(self.file), self.compat)

    def objective(self, x, *, threads=1, client=None):
        """Objective of a calibration at `x`: mean NMSE of the fitted channels; infinite where the model has no response."""
        if client is None:
            return super().objective(x, threads=threads)
        return self._submit(client, "objective", x)

    def residuals(self, x, *, threads=1, client=None):
        """Scaled differences between model and recordings at `x`, whose sum of squares is the objective."""
        if client is None:
            return super().residuals(x, threads=threads)
        return self._submit(client, "residuals", x)

    def loglike(self, x, *, n=None, threads=1, client=None):
        """Logarithm of the likelihood at `x` but for a constant: -n/2 ln(objective).

        `n` is the number of independent samples, by default `effective_samples()`, which calibrates the study once.
        """
        if client is None:
            return super().loglike(x, n=n, threads=threads)
        n = self.effective_samples(threads=threads) if n is None else n
        return self._submit(client, "loglike", x, n=n)

    def objective_many(self, x, *, threads=1, client=None):
        """`objective` at the rows of `x`, on several threads or on the workers of Dask."""
        if client is None:
            return super().objective_many(_points(x), threads=threads)
        return self._submit_many(client, "objective_many", x)

    def residuals_many(self, x, *, threads=1, client=None):
        """`residuals` at the rows of `x`, an array of shape (points, samples), on several threads or on the workers of Dask."""
        if client is None:
            return super().residuals_many(_points(x), threads=threads)
        return self._submit_many(client, "residuals_many", x)

    def loglike_many(self, x, *, n=None, threads=1, client=None):
        """`loglike` at the rows of `x`, on several threads or on the workers of Dask."""
        if client is None:
            return super().loglike_many(_points(x), n=n, threads=threads)
        # Once here, not in each worker.
        n = self.effective_samples(threads=threads) if n is None else n
        return self._submit_many(client, "loglike_many", x, n=n)

    def _submit_many(self, client, name, x, **options):
        import numpy as np

        points = np.atleast_2d(_points(x))
        tasks = min(len(points), max(1, 4 * sum(client.nthreads().values())))
        parts = [p for p in np.array_split(points, tasks) if len(p)] if tasks else []
        futures = [client.submit(_evaluate, self.__reduce__()[1], name, p, options, pure=False) for p in parts]
        # No point needs no worker.
        return np.concatenate(client.gather(futures)) if futures else getattr(super(), name)(points, **options)

    def _submit(self, client, name, x, **options):
        return client.submit(_evaluate, self.__reduce__()[1], name, list(x), options, pure=False).result()

    def calibrate(self, *, method=None, seed=None, evaluations=None, threads=1):
        """Find the parameters that fit the recordings best."""
        found = self._calibrate(method=method, seed=seed, evaluations=evaluations, threads=threads)
        return Calibration(*found, self.names)

    def diagnose(self, *, without=(), threads=1):
        """Name the physics that the model leaves out. ``without`` has causes that are not considered."""
        return Diagnosis(*self._diagnose(without=list(without), threads=threads))

    def learn(self, *, threads=1):
        """Learn a law with memory from the runs of a device."""
        return Learned(*self._learn(threads=threads))


def _points(x):
    import numpy as np

    return np.asarray(x, dtype=float)


#: The study that a worker has read last.
_read = {}


def _study(file, compat):
    return Study(file, compat=compat)


def _evaluate(key, name, x, options):
    """Evaluate a study on a worker."""
    study = _read.get(key)
    if study is None:
        _read.clear()
        study = _read[key] = _study(*key)
    return getattr(study, name)(x, **options)
