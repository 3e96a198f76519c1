/* SPDX-License-Identifier: MIT */
#include "cut.h"

#include "../atomic_file.h"
#include "../complain.h"
#include "../folder.h"
#include "../json_file.h"
#include "../progress.h"
#include "allowance.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

cut_request cut = {.keep = 30};

/* What is under way. */
static struct {
    const cut_work *work;
    json_t *asked;
    index_ranges done;
    index_range now; /* what is worked off */
    char *part;
    allowance left;
    bool stopped;
} piece;

/* What is asked, with what only the command knows. */
static void complete(const cut_work *work)
{
    json_t *inputs = json_object();
    bool set = !work->input.path ||
               json_object_set_new(inputs, work->input.path, json_bits(work->input.hash)) == 0;
    json_object_set_new(cut.asked, work->unit, json_integer((json_int_t)work->total));
    if (!set || json_object_set_new(cut.asked, "inputs", inputs) != 0)
        abort();
}

/* Planning. */

static json_t *piece_json(uint64_t number, uint64_t total)
{
    const uint64_t whole = total / cut.pieces, more = total % cut.pieces;
    uint64_t first = (number - 1) * whole + (number - 1 < more ? number - 1 : more);
    index_range range = {first, first + whole + (number - 1 < more)};
    json_t *ranges = ranges_json(&(index_ranges){&range, 1});
    return json_pack("{s:I, s:o}", "piece", (json_int_t)number, "ranges", ranges);
}

static bool is_input(const cut_work *work, const char *path)
{
    return work->input.path && folder_is_same_file(path, work->input.path);
}

static int plan(const cut_work *work)
{
    if (is_input(work, cut.manifest)) {
        complain(stderr, cut.manifest, "a manifest may not take the place of a file that is read");
        return 2;
    }
    if (cut.pieces > work->total || work->total > RANGES_MOST) {
        complain(stderr, cut.manifest, "there are %s than %" PRIu64 " %s",
                 cut.pieces > work->total ? "no more" : "more",
                 cut.pieces > work->total ? work->total : RANGES_MOST, work->unit);
        return 2;
    }
    json_t *lines = json_array();
    json_array_append(lines, cut.asked);
    for (uint64_t i = 1; i <= cut.pieces; i++)
        json_array_append_new(lines, piece_json(i, work->total));
    if (!sealed_write(lines, cut.manifest, stderr))
        return 1;
    printf("%s: %" PRIu64 " pieces of %" PRIu64 " %s\n", cut.manifest, cut.pieces, work->total,
           work->unit);
    return 0;
}

/* Results. */

typedef struct {
    json_t *lines;
    index_ranges done;
    bool of_others; /* it is whole, and something else was asked */
} result;

static void result_free(result *of)
{
    json_decref(of->lines);
    free(of->done.of);
}

static const json_t *result_told(const result *of)
{
    return json_array_get(of->lines, 2);
}

/* Of what is asked, as `whose` has it, too. */
static bool result_read(const char *path, const json_t *asked, const char *whose, result *read)
{
    *read = (result){.lines = sealed_read(path, stderr)};
    if (!read->lines)
        return false;
    const char *other = asked_difference(asked, json_array_get(read->lines, 0));
    const char *wrong =
        other ? NULL
              : ranges_take(json_object_get(json_array_get(read->lines, 1), "ranges"), &read->done);
    if (!other && !wrong && json_array_size(read->lines) == 3)
        return true;
    result_free(read);
    read->of_others = other != NULL;
    if (other)
        return complain(stderr, path, "it has another %s than %s", other, whose);
    return complain(stderr, path, "%s", wrong ? wrong : "expected a result");
}

static bool result_write(const char *path)
{
    json_t *told = piece.work->tell(piece.work->sum, &piece.done);
    json_t *lines =
        told ? json_pack("[O, {s:o}, o]", piece.asked, "ranges", ranges_json(&piece.done), told)
             : NULL;
    return sealed_write(lines, path, stderr);
}

static bool is_within(const index_ranges *some, const index_ranges *all)
{
    index_range gap;
    for (size_t i = 0; i < some->count; i++) {
        if (ranges_gap(all, some->of[i], &gap))
            return false;
    }
    return true;
}

/* Are there so many parts? */
static bool are_parts(const cut_work *work, const index_ranges *some)
{
    return is_within(some, &(index_ranges){&(index_range){0, work->total}, 1});
}

/* To be freed by free(wanted->of), whatever is returned. */
static bool read_piece(const manifest *of, size_t number, index_ranges *wanted)
{
    const json_t *line = manifest_piece(of, number, stderr);
    *wanted = (index_ranges){NULL, 0};
    const char *wrong = line ? ranges_take(json_object_get(line, "ranges"), wanted) : NULL;
    return line && (!wrong || complain(stderr, of->path, "piece %zu: %s", number, wrong));
}

/* Reads what was found of the piece, if that is there and is of this piece. */
static bool read_found(const manifest *of, const index_ranges *wanted, const char *path,
                       result *found)
{
    found->of_others = !folder_entry_ok(path, stderr);
    if (found->of_others || access(path, F_OK) != 0 ||
        !result_read(path, manifest_asked(of), of->path, found))
        return false;
    if (is_within(&found->done, wanted))
        return true;
    result_free(found);
    found->of_others = true;
    return complain(stderr, path, "it is of another piece");
}

/* The part of the piece that is in FOLDER/NUMBER and the ending; less than 0: what is there is
 * others'. */
static double part_of(const manifest *of, size_t number, const index_ranges *wanted,
                      const char *folder, const char *ending)
{
    result found;
    double part = 0;
    char *path = piece_path(folder, number, ending);
    if (read_found(of, wanted, path, &found)) {
        part = (double)ranges_total(&found.done) / (double)ranges_total(wanted);
        result_free(&found);
    } else if (found.of_others) {
        part = -1;
    }
    free(path);
    return part;
}

double cut_done(const manifest *of, size_t number, const char *folder)
{
    index_ranges wanted;
    double done = 0;
    if (read_piece(of, number, &wanted)) {
        done = part_of(of, number, &wanted, folder, ".json");
        if (done >= 0 && done < 1)
            done = fmin(part_of(of, number, &wanted, folder, ".part"), nextafter(1, 0));
    }
    free(wanted.of);
    return done;
}

/* Working off. */

bool cut_is_due(void)
{
    return cut.way == CUT_WORK && allowance_look(&piece.left) != ALLOWANCE_LEFT;
}

static void note(uint64_t end)
{
    if (piece.now.first < end && !ranges_add(&piece.done, (index_range){piece.now.first, end}))
        abort();
    piece.now.first = end;
}

bool cut_goes_on(uint64_t end)
{
    allowance_state left = allowance_look(&piece.left);
    if (left == ALLOWANCE_LEFT || end == piece.now.end)
        return true;
    note(end);
    allowance_kept(&piece.left);
    bool kept = result_write(piece.part);
    piece.stopped = !kept || left == ALLOWANCE_OVER;
    if (kept && piece.stopped)
        complain(stderr, piece.part, "no processor time is left");
    return !piece.stopped;
}

/* Takes up what was kept. False: a part of it is in the sum already, and the rest can't be. */
static bool go_on(const index_ranges *wanted)
{
    result found;
    if (!read_found(&cut.of, wanted, piece.part, &found))
        return true;
    const char *wrong = piece.work->add(piece.work->sum, &found.done, result_told(&found));
    if (wrong) {
        complain(stderr, piece.part, "%s", wrong);
    } else {
        piece.done = found.done;
        found.done = (index_ranges){NULL, 0};
    }
    result_free(&found);
    return !wrong;
}

static bool work_off(const index_ranges *wanted)
{
    const cut_work *work = piece.work;
    for (size_t i = 0; i < wanted->count; i++) {
        while (ranges_gap(&piece.done, wanted->of[i], &piece.now)) {
            if (!work->work(work->sum, piece.now) || piece.stopped)
                return false;
            note(piece.now.end);
        }
    }
    return true;
}

static int work_piece(const cut_work *work)
{
    index_ranges wanted;
    const char *other = asked_difference(manifest_asked(&cut.of), cut.asked);
    if (other) {
        complain(stderr, cut.of.path, "is for other work than this program's: it has another %s",
                 other);
        return 2;
    }
    bool read = read_piece(&cut.of, cut.number, &wanted);
    if (!read || !are_parts(work, &wanted)) {
        if (read)
            complain(stderr, cut.of.path, "piece %zu: there are no such %s", cut.number,
                     work->unit);
        free(wanted.of);
        return 2;
    }
    char *path = piece_path(cut.folder, cut.number, ".json");
    piece.work = work;
    piece.asked = cut.asked;
    piece.part = piece_path(cut.folder, cut.number, ".part");
    piece.left = allowance_of(cut.keep, cut.limit);
    bool done = atomic_file_possible(path, stderr) && go_on(&wanted) && work_off(&wanted) &&
                result_write(path);
    if (done)
        unlink(piece.part);
    free(piece.done.of);
    free(piece.part);
    free(wanted.of);
    free(path);
    return done ? 0 : 1;
}

/* Adding. */

typedef struct {
    const cut_work *work;
    index_ranges *of; /* of each result */
    index_ranges sum;
} adding;

static bool is_new(const adding *all, int at, const index_ranges *next)
{
    char *const *paths = cut.results->names;
    index_range both;
    for (int i = 0; i < at; i++) {
        if (ranges_overlap(&all->of[i], next, &both))
            return complain(stderr, paths[at], "%s %" PRIu64 " to %" PRIu64 " are in %s, too",
                            all->work->unit, both.first, both.end - 1, paths[i]);
    }
    return true;
}

static bool add_result(adding *all, int at)
{
    const char *path = cut.results->names[at];
    result next;
    if (!result_read(path, cut.asked, at > 0 ? cut.results->names[0] : "here", &next))
        return false;
    bool fits = are_parts(all->work, &next.done)
                    ? is_new(all, at, &next.done)
                    : complain(stderr, path, "there are no such %s", all->work->unit);
    const char *wrong =
        fits ? all->work->add(all->work->sum, &next.done, result_told(&next)) : NULL;
    for (size_t i = 0; i < next.done.count; i++) {
        if (fits && !wrong && !ranges_add(&all->sum, next.done.of[i]))
            abort();
    }
    all->of[at] = next.done;
    next.done = (index_ranges){NULL, 0};
    result_free(&next);
    return wrong ? complain(stderr, path, "%s", wrong) : fits;
}

static int merge(const cut_work *work)
{
    const int count = cut.results->count;
    adding all = {.work = work, .of = calloc((size_t)count, sizeof *all.of)};
    index_range gap;
    bool added = all.of != NULL;
    progress bar = progress_start(stderr, count);
    for (int i = 0; added && i < count; i++) {
        added = add_result(&all, i);
        progress_step(&bar, added);
    }
    progress_finish(&bar);
    if (added && ranges_gap(&all.sum, (index_range){0, work->total}, &gap))
        added = complain(stderr, cut.results->names[0],
                         "%s %" PRIu64 " to %" PRIu64 " of %" PRIu64 " are missing", work->unit,
                         gap.first, gap.end - 1, work->total);
    for (int i = 0; all.of && i < count; i++)
        free(all.of[i].of);
    free(all.of);
    free(all.sum.of);
    return added ? CUT_GOES_ON : 2;
}

int cut_do(const cut_work *work)
{
    if (cut.way == CUT_NOT)
        return CUT_GOES_ON;
    complete(work);
    return cut.way == CUT_PLAN ? plan(work) : cut.way == CUT_WORK ? work_piece(work) : merge(work);
}
