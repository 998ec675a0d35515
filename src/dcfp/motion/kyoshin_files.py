"""The files of K-NET and KiK-net that are one station's: by what their names have in common, or by the folder that they are in."""

from pathlib import Path

from dcfp.errors import InputError

#: What ends the names of x, y and the vertical: of K-NET, and of KiK-net at the surface and in the borehole.
_ENDINGS = ((".EW", ".NS", ".UD"), (".EW2", ".NS2", ".UD2"), (".EW1", ".NS1", ".UD1"))
_KNOWN = {ending.casefold() for endings in _ENDINGS for ending in endings}
_WORDS = "of K-NET (.EW, .NS, .UD) or KiK-net (.EW2, .NS2, .UD2)"


def station_files(text: str) -> list[Path]:
    """Return the files of x, y and, where there is one, the vertical; none where `text` is neither what such files have in common nor a folder.

    Of KiK-net those at the surface go before those in the borehole.

    Raises
    ------
    InputError
        If there is only one horizontal component, or a folder holds the files of no station or of several.
    """
    if not text.strip():
        return []  # no name is not this folder
    place = Path(text)
    try:
        is_folder = place.is_dir()
        stems = sorted({file.stem for file in place.iterdir() if file.suffix.casefold() in _KNOWN}) if is_folder else []  # fmt: skip
    except (OSError, ValueError):  # no name of a file, or one that may not be read
        return []
    return _of_folder(place, stems) if is_folder else _of_stem(place)


def vertical_beside(name: str) -> str:
    """Return the name of the file of the vertical that belongs to that of x; empty where it is not one of K-NET or KiK-net."""
    file = Path(name)
    found = [up for x, _, up in _ENDINGS if file.suffix.upper() == x]
    return file.with_suffix(found[0]).name if found else ""


def _of_stem(stem: Path) -> list[Path]:
    if not stem.name:
        return []
    for endings in _ENDINGS:
        found = [
            next((file for word in (one, one.lower()) if (file := Path(f"{stem}{word}")).is_file()), None)
            for one in endings
        ]
        present = [file for file in found if file is not None]
        if None not in found[:2]:
            return present
        if present:
            missing = endings[0 if found[0] is None else 1]
            there = ", ".join(file.name for file in present)
            msg = f"{stem}: the station lacks the file {stem.name}{missing} beside {there}; both horizontal components are needed."
            raise InputError(msg)
    return []


def _of_folder(folder: Path, stems: list[str]) -> list[Path]:
    if len(stems) == 1:
        return _of_stem(folder / stems[0])
    if not stems:
        msg = f"{folder}: a folder is a station where it holds the files {_WORDS} of one record, and this one holds none; name a file in it."
        raise InputError(msg)
    few = ", ".join(stems[:3]) + (" and others" if len(stems) > 3 else "")
    msg = f"{folder}: the folder holds the files of several records, {few}; name one, as in {folder / stems[0]}."
    raise InputError(msg)
