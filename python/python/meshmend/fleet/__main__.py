"""Many files from the command line: mend or check them, or look after the table of their rows."""

import argparse
import json
import sys

from . import check, compact, mend, summary

def main() -> int:
    """0 if every file has a result, 1 if some have none; 2 is for words that are wrong."""
    parser = argparse.ArgumentParser(prog="python -m meshmend.fleet", description=__doc__)
    tasks = parser.add_subparsers(dest="task", required=True)
    for task in ("mend", "check"):
        words = tasks.add_parser(task, help=f"{task} files, and write a row for each")
        words.add_argument("source", nargs="+", help="folders and globs, here or in a store")
        words.add_argument("--table", required=True, help="the folder of the rows")
        for name in ("to", "format") if task == "mend" else ():
            words.add_argument(f"--{name}", required=name == "to", help=f"the {'folder' if name == 'to' else 'format'} of the results")
        for name, kind in {"plan": str, "timeout": float, "memory": str, "concurrency": int, "scratch": str}.items():
            words.add_argument(f"--{name}", type=kind)
        words.add_argument("--retry", type=lambda ends: ends.split(","), default=(), help="do these again: timeout,memory,crashed")
        words.add_argument("--no-resume", dest="resume", action="store_false", help="do files again that have a row")
        words.add_argument("--reports", action="store_true", help="put whole reports into the rows")
    for task in ("compact", "summary"):
        tasks.add_parser(task, help=f"{task} of a table").add_argument("table")
    words = vars(parser.parse_args())
    task = words.pop("task")
    if task in ("mend", "check"):
        ended = {"mend": mend, "check": check}[task](**words, progress=sys.stderr.isatty())
        print(json.dumps({"files": sum(ended.values()), "status": ended}))
        return 0 if {"mended", "clean", "left"}.issuperset(ended) else 1
    if task == "compact":
        compact(words["table"])
    print(json.dumps(summary(words["table"])))
    return 0


if __name__ == "__main__":
    sys.exit(main())
