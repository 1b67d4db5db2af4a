#!/usr/bin/env python3
"""Concealed in models of foreign kinds, by the means of ../unfamiliar: writes `cases/`, `truth/` and `concealed/`, and seals them.

    python3 make.py --opensees "python -m opensees"
"""

import importlib.util
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
path = os.path.join(HERE, "..", "unfamiliar", "make.py")
spec = importlib.util.spec_from_file_location("unfamiliar_make", path)
base = importlib.util.module_from_spec(spec)
spec.loader.exec_module(base)

base.HERE = HERE
base.NAMES = ("avocet", "bittern", "curlew", "dunlin", "egret", "fulmar", "gannet", "heron", "ibis", "jackdaw", "kestrel", "linnet")
base.further = base.loaded("foreign_models", os.path.join(HERE, "models.py"))
base.means.Structure.context = base.further.context
base.means.columns = base.further.columns_of(base.means.columns)

if __name__ == "__main__":
    sys.argv[1:1] = ["--seed", "83"]
    base.main()
