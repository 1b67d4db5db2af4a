"""Batch 4: twelve models by an author who did not know the diagnosis."""

from .batch_4_first import case_a, case_b, case_c, case_d, case_e, case_f
from .batch_4_second import case_g, case_h, case_i, case_j, case_k, case_l

SEED, STREAM = 83, "unfamiliar"
NAMES = ("avocet", "bittern", "curlew", "dunlin", "egret", "fulmar", "gannet", "heron", "ibis", "jackdaw", "kestrel", "linnet")
CASES = (case_e, case_j, case_a, case_l, case_f, case_c, case_h, case_i, case_k, case_g, case_b, case_d)
# Steps of the recorders that write no time.
UNTIMED = {"untimed.txt": 0.01, "rows.txt": 0.0125}
