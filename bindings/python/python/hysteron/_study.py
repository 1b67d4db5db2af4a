"""Studies: calibration, diagnosis, and the objective for any optimiser."""

import json

from . import _hysteron


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

    @property
    def parameters(self):
        """Values by the names of the parameters."""
        return {p["name"]: p["value"] for p in self.table["parameters"]}

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

    ``names``, ``bounds`` and ``initial`` describe the free parameters; ``x`` has their values in that order.
    """

    def calibrate(self, *, method=None, seed=None, evaluations=None, threads=1):
        """Find the parameters that fit the recordings best."""
        return Calibration(*self._calibrate(method=method, seed=seed, evaluations=evaluations, threads=threads))

    def diagnose(self, *, without=(), threads=1):
        """Name the physics that the model leaves out. ``without`` has causes that are not considered."""
        return Diagnosis(*self._diagnose(without=list(without), threads=threads))
