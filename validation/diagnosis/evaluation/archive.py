"""Archives of sealed batches: `batches/N.tar.xz`, in which tables of numbers are kept by `columns`.

    cases/NAME/       what the analyst has: study.toml, model.tcl, motions (.dat), recordings (.csv)
    truth/NAME.json   what is concealed, where, and the noise
    concealed/        the scripts that OpenSees ran, of batches 1 to 4
    *.py              the programs of the batch, as they were when it was made
    sealed.sha256     the digests that were published before any case was diagnosed
"""

import hashlib
import io
import lzma
import os
import tarfile

from . import columns

# Two decimal digits make a byte here and rarely repeat, so neighbouring bytes say nothing of the next.
FILTERS = [{"id": lzma.FILTER_LZMA2, "preset": 9 | lzma.PRESET_EXTREME, "lc": 0, "lp": 0, "pb": 0}]
CODED = ".columns"
SEALS = "sealed.sha256"


def files_below(folder):
    """Paths of all files below a folder, relative to it and sorted."""
    found = (os.path.relpath(os.path.join(root, name), folder) for root, _, names in os.walk(folder) for name in names)
    return sorted(path.replace(os.sep, "/") for path in found)


def digest(folder, paths):
    """One digest of the names and contents of files."""
    lines = [f"{sha256(os.path.join(folder, path))}  {path}\n" for path in paths]
    return hashlib.sha256("".join(lines).encode()).hexdigest()


def sha256(path):
    with open(path, "rb") as f:
        return hashlib.sha256(f.read()).hexdigest()


def broken_seals(folder):
    """Files that are not what was sealed."""
    with open(os.path.join(folder, SEALS)) as f:
        pairs = [line.split() for line in f]
    return [path for seal, path in pairs if sha256(os.path.join(folder, path)) != seal]


def pack(folder, target):
    """Writes all files of a folder to an archive, the same bytes for the same files, and returns their digest."""
    paths = files_below(folder)
    with lzma.open(target, "wb", check=lzma.CHECK_CRC64, filters=FILTERS) as out, tarfile.open(fileobj=out, mode="w", format=tarfile.USTAR_FORMAT) as tar:
        for path in paths:
            with open(os.path.join(folder, path), "rb") as f:
                data = f.read()
            coded = columns.encode(data.decode()) if path.endswith((".csv", ".dat")) else None
            entry = tarfile.TarInfo(path if coded is None else path + CODED)
            data = data if coded is None else coded
            entry.size = len(data)
            tar.addfile(entry, io.BytesIO(data))
    return digest(folder, paths)


def unpack(source, folder):
    """Writes the files of an archive below a folder, and returns their digest."""
    paths = []
    with lzma.open(source) as data, tarfile.open(fileobj=data, mode="r:") as tar:
        for entry in tar:
            content = tar.extractfile(entry).read()
            path = entry.name
            if path.endswith(CODED):
                path, content = path.removesuffix(CODED), columns.decode(content).encode()
            place = os.path.join(folder, path)
            os.makedirs(os.path.dirname(place), exist_ok=True)
            with open(place, "wb") as f:
                f.write(content)
            paths.append(path)
    return digest(folder, sorted(paths))
