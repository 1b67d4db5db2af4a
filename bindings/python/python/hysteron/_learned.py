"""Learned laws with memory."""

from . import _hysteron


class LearnedLaw(_hysteron.LearnedLaw):
    """A learned law of one direction; ``LearnedLaw(text)`` reads the JSON that ``hysteron learn`` writes.

    ``force(u, t, channels=None)`` is its force along a motion from rest.
    """


class Learned:
    """Result of ``Study.learn``."""

    def __init__(self, json, parts, remarks, errors, script):
        #: The law.
        self.law = LearnedLaw(json)
        #: Its parts and factors in words.
        self.parts = parts
        #: What it is worth, in words.
        self.remarks = remarks
        #: Mean NMSE by name: ``fitted``, ``blocks``, ``held_out``; of the user's law ``user_fitted``, ``user_held_out``.
        self.errors = errors
        #: The script with the law; None where the force is not that of one element.
        self.script = script

    def __repr__(self):
        return f"<Learned {'; '.join(self.parts)}>"
