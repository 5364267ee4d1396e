"""The faults that mutate.py plants: lists in tests/mutation/faults/*.json of
  {"id": "...", "file": "core/...", "find": "text, once in the file", "replace": "...",
   "breaks": "what a user would see", "survives": "optional: why no test can catch it"}
"""

import collections
import hashlib
import json


def load_records(folder):
    return [record for file in sorted(folder.glob("*.json")) for record in json.loads(file.read_text())]


def problems(records, root):
    """What is wrong with the records: one line for each that cannot be planted."""
    wrong = []
    for name, count in collections.Counter(record.get("id") for record in records).items():
        if count > 1:
            wrong.append(f"{name}: {count} records have this id")
    for record in records:
        name = record.get("id", "(no id)")
        if missing := {"id", "file", "find", "replace", "breaks"} - record.keys():
            wrong.append(f"{name}: lacks {', '.join(sorted(missing))}")
        elif not (root / record["file"]).is_file():
            wrong.append(f"{name}: there is no {record['file']}")
        elif (times := (root / record["file"]).read_text().count(record["find"])) != 1:
            wrong.append(f"{name}: its text is {times} times in {record['file']}: {record['find']}")
        elif record["find"] == record["replace"]:
            wrong.append(f"{name}: changes nothing")
    return wrong


def planted(record):
    """Changes with what the fault does to its file."""
    return hashlib.sha256(json.dumps([record[key] for key in ("file", "find", "replace")]).encode()).hexdigest()
