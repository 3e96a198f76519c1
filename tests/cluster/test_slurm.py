# SPDX-License-Identifier: MIT
"""How slurm.py watches a queue, by a cluster that says what is told and works tasks off at once.

    test_slurm.py"""
import contextlib
import io
import os
import pathlib
import sys
import unittest
from unittest import mock

HERE = pathlib.Path(__file__).resolve().parent
sys.argv = [sys.argv[0], str(HERE.parent / "campaign" / "slurm.py")]
sys.path[:0] = [str(HERE.parent / "support"), str(HERE.parent / "campaign")]
import slurm  # noqa: E402
from commands import InFolder, contents, put  # noqa: E402

GONE = ("slurm_load_jobs error: Invalid job id specified", 1)
AWAY = ("slurm_load_jobs error: Unable to contact slurm controller (connect failure)", 1)

# Each question of squeue takes the next line of `queue`: a status, and what is said.
SQUEUE = """#!/bin/sh
read -r status words < queue
sed -i 1d queue
if [ "$status" = 0 ]; then echo "$words"; else echo "$words" >&2; fi
exit "$status"
"""
# `lose` holds numbers whose tasks fail the first time.
SBATCH = """#!/bin/sh
echo "$@" >> submitted
[ ! -e refuse ] || exit 1
task=$(cat)
for word; do
    case $word in --array=*) array=${word#--array=} ;; esac
done
echo "$array" | tr , '\\n' | while IFS=- read -r first last; do
    for SLURM_ARRAY_TASK_ID in $(seq "$first" "$last"); do
        export SLURM_ARRAY_TASK_ID
        sh -c "$task" || true
    done
done
echo "7;cluster"
"""
# Of three pieces.
CAMPAIGN = """#!/bin/sh
case $1 in
status)
    missing=
    for i in 0 1 2; do
        [ -e "$3/$i.json" ] || missing=$missing,$i
    done
    echo "${missing#,}"
    echo "so far 50.0 % of all" >&2
    [ -z "$missing" ] || exit 3 ;;
work)
    ! sed -i "/^$3\\$/{w lost
        d}" lose || [ ! -s lost ] || exit 1
    echo "$@" >> worked
    touch "$4/$3.json" ;;
merge)
    [ "$3" = -o ] && ls "$2" | grep json | tr '\\n' ' ' > "$4" ;;
esac
"""


class Queue(InFolder):
    def setUp(self):
        super().setUp()
        os.mkdir("bin")
        for name, text in (("bin/squeue", SQUEUE), ("bin/sbatch", SBATCH), ("campaign", CAMPAIGN),
                           ("bin/scontrol", "#!/bin/sh\necho 'MaxArraySize = 2'\n")):
            put(name, text)
            os.chmod(name, 0o755)
        put("lose", "")

    def work(self, queue, *options, besides=os.environ["PATH"]):
        """What it ends with, prints and says, where the queue is told so."""
        put("queue", "".join(f"{status} {words}\n" for words, status in queue))
        said, told = io.StringIO(), io.StringIO()
        with mock.patch.dict(os.environ, PATH=f"{os.getcwd()}/bin:{besides}"), \
                mock.patch.object(slurm, "SECONDS", 0), \
                mock.patch.object(sys, "argv", ["slurm.py", "campaign", "manifest", "pieces",
                                                "record", *options]), \
                contextlib.redirect_stdout(said), contextlib.redirect_stderr(told), \
                self.assertRaises(SystemExit) as end:
            slurm.main()
        return end.exception.code, said.getvalue(), told.getvalue()

    def lines(self, name):
        return contents(name).decode().splitlines()

    def test_pieces_are_submitted_watched_and_added(self):
        code, said, told = self.work([("RUNNING PENDING", 0), GONE, ("", 0)], "--limit", "9",
                                     "--time=30")
        self.assertEqual((code, told), (0, ""))
        self.assertEqual(said, "job 7: 2 of 3 pieces done, 1 running, 1 waiting\n")
        # No array is longer than the cluster takes.
        self.assertEqual([line.split()[2] for line in self.lines("submitted")],
                         ["--array=0-0,1-1", "--array=0-0"])
        self.assertTrue(all(line.endswith(" --time=30") for line in self.lines("submitted")))
        self.assertEqual([line.split()[2:] for line in self.lines("worked")],
                         [[str(i), f"{os.getcwd()}/pieces", "--limit", "9"] for i in range(3)])
        self.assertEqual(self.lines("record"), ["0.json 1.json 2.json "])

    def test_a_controller_that_is_away_is_asked_again(self):
        code, said, told = self.work([("RUNNING", 0), AWAY, AWAY, ("RUNNING", 0), GONE, GONE])
        self.assertEqual((code, len(self.lines("submitted"))), (0, 2))
        self.assertEqual(told, 2 * f"slurm.py: {AWAY[0]}; asked again\n")
        self.assertEqual(len(said.splitlines()), 2)

    def test_what_fails_is_submitted_again(self):
        put("lose", "1\n")
        self.assertEqual(self.work(3 * [GONE])[0], 0)
        self.assertEqual([line.split()[2] for line in self.lines("submitted")],
                         2 * ["--array=0-0,1-1"])

    def test_it_ends_where_nothing_gets_on(self):
        put("campaign", CAMPAIGN.replace("work)", "work) exit 1"))
        code = self.work(3 * [GONE])[0]
        self.assertEqual(code, f"slurm.py: nothing gets on; {os.getcwd()}/pieces/logs has what "
                               "tasks said")
        self.assertEqual(len(self.lines("submitted")), 3)

    def test_it_ends_without_a_cluster(self):
        put("refuse", "")
        self.assertEqual(self.work([])[0], "slurm.py: sbatch took no job")
        os.remove("bin/scontrol")
        self.assertEqual(self.work([], besides="")[0],
                         "slurm.py: scontrol: No such file or directory")
        put("campaign", "#!/bin/sh\necho no manifest >&2\nexit 2\n")
        put("bin/scontrol", "#!/bin/sh\necho 'MaxArraySize = 2'\n")
        os.chmod("bin/scontrol", 0o755)
        at = os.getcwd()
        self.assertEqual(self.work([])[0], f"slurm.py: {at}/campaign status {at}/manifest "
                                           f"{at}/pieces: no manifest")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
