"""Folders and files here and in object stores, with the file systems and credentials of Daft."""

from __future__ import annotations

import os
import re
import shutil
from typing import Any, BinaryIO, NamedTuple

import daft
from daft.filesystem import _resolve_paths_and_filesystem
from pyarrow import fs

ENDINGS = (".obj", ".ply", ".stl", ".off", ".glb", ".gltf", ".3mf")


class File(NamedTuple):
    path: str
    base: str
    size: int
    mtime: int | None


def is_local(url: str) -> bool:
    return "://" not in url


def plain(url: str | os.PathLike[str]) -> str:
    """A path of this machine without a scheme, and whole; addresses as they are."""
    url = os.fspath(url).removeprefix("file://")
    return os.path.abspath(url) + "/" * url.endswith("/") if is_local(url) else url


def within(url: str, io_config: Any) -> tuple[fs.FileSystem, str]:
    """The file system of an address, and what it is called there."""
    (path,), system = _resolve_paths_and_filesystem(url, io_config)
    return system, path


def files_below(folder: str, io_config: Any) -> list[File]:
    """All files below a folder; none where there is no folder."""
    system, path = within(folder, io_config)
    infos = system.get_file_info(fs.FileSelector(path, allow_not_found=True, recursive=True))
    base = folder.rstrip("/") + "/"
    begin = len(path.rstrip("/")) + 1
    return [File(base + info.path[begin:], base, info.size, info.mtime_ns) for info in infos if info.is_file]


def listing(source: str, io_config: Any) -> list[File]:
    """The meshes below a folder, or what a glob matches."""
    source = plain(source)
    if source.endswith("/") or os.path.isdir(source):
        return [file for file in files_below(source, io_config) if file.path.lower().endswith(ENDINGS)]
    base = re.split(r"[*?\[{]", source)[0].rpartition("/")[0] + "/"
    try:
        found = daft.from_glob_path(source, io_config).to_pydict()
    except Exception as error:
        raise FileNotFoundError(f"{source}: {error}") from error
    times = {file.path: file.mtime for file in files_below(base, io_config)}
    paths = map(plain, found["path"])
    return [File(path, base, size, times.get(path)) for path, size in zip(paths, found["size"], strict=True)]


def put(url: str, data: BinaryIO, io_config: Any) -> None:
    """Writes a file of which nothing is seen before it is whole."""
    system, path = within(url, io_config)
    written = f"{os.path.dirname(path)}/.{os.path.basename(path)}.new" if is_local(url) else path
    if is_local(url):
        os.makedirs(os.path.dirname(path), exist_ok=True)
    with system.open_output_stream(written) as file:
        shutil.copyfileobj(data, file, 8 << 20)
    if is_local(url):
        os.replace(written, path)
