"""Prints "ok NAME" or "bad NAME: why" for each action log, as the JSON Schema of single lines sees it.

usage: check_schema.py SCHEMA EVERY LOG...    looks at the first 50 lines and then at every EVERY-th
"""
import gzip
import json
import sys

import jsonschema


def lines(path):
    with open(path, "rb") as file:
        start = file.read(2)
    opened = gzip.open(path) if start == b"\x1f\x8b" else open(path, "rb")
    with opened as file:
        yield from enumerate(file, 1)


def problem(validator, path, every):
    for number, line in lines(path):
        if not line.strip() or (number > 50 and number % every != 0):
            continue
        expected = "header" if number == 1 else "event"
        error = next(validator.iter_errors(json.loads(line)), None)
        if error is not None:
            return f"line {number}, {expected}: {error.message}"
    return None


def main():
    schema = json.load(open(sys.argv[1], encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    for path in sys.argv[3:]:
        found = problem(validator, path, int(sys.argv[2]))
        print(f"bad {path}: {found}" if found else f"ok {path}")


main()
