"""What the judge says of a tier that promises to be right, by the reference:

    test_judge_by_reference.py SUREHIT certain|exact

Every shape and regime; prints how many cases."""

import json
import os
import subprocess
import sys
import tempfile

COUNT = 1000  # of each shape and regime
PROMISES = {"certain": "decisions,contract", "exact": "decisions,contract,t<=0ulp,normal<=0ulp"}


def judge(surehit, tier, path):
    """The verdict, whether the promises are kept or broken."""
    subprocess.run([surehit, "judge", "--tier", tier, "--truth", "reference", "--count",
                    str(COUNT), "--require", PROMISES[tier], "--json", path], check=False,
                   stdout=subprocess.DEVNULL)
    with open(path, encoding="ascii") as file:
        return json.load(file)


def faults_of(verdict, lines):
    if verdict["truth"] != "reference":
        yield "held against " + verdict["truth"]
    if len(verdict["rows"]) != lines:
        yield f"{len(verdict['rows'])} rows, not {lines}"
    for row in verdict["rows"]:
        where = f"{row['shape']} {row['regime']}"
        if row["cases"] != COUNT or row["valid"] == 0:
            yield f"{where}: {row['cases']} cases, {row['valid']} of them valid"
        if row["hits"] == 0 or row["hits"] == row["cases"]:
            yield f"{where}: {row['hits']} hits"
    yield from (f"broken: {one['promise']}" for one in verdict["required"] if not one["kept"])


def main():
    surehit, tier = os.path.abspath(sys.argv[1]), sys.argv[2]
    pairs = subprocess.run([surehit, "cases", "--count", "1"], check=True, capture_output=True)
    with tempfile.TemporaryDirectory(prefix="test_judge_by_reference.") as folder:
        verdict = judge(surehit, tier, os.path.join(folder, "verdict.json"))
    faults = list(faults_of(verdict, len(pairs.stdout.splitlines())))
    hits = sum(row["t_ulps"]["hits"] for row in verdict["rows"])
    print(*faults, sep="\n", end="\n" if faults else "")
    print(f"{tier} by the reference: {sum(row['cases'] for row in verdict['rows']):,} cases in "
          f"{len(verdict['rows'])} rows, {hits:,} hits")
    print("0 passed, 1 failed" if faults else "1 passed, 0 failed")
    return 1 if faults else 0


sys.exit(main())
