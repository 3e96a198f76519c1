/* Shares in files: what is written is read, whatever else is refused; sums in any order. */
#define _POSIX_C_SOURCE 200809L /* mkdtemp, open_memstream */

#include "../../src/photons/partial_film.h"
#include "../support/suite.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define PATH "a.share"

/* Every test runs in a folder of its own. */
static char folder[] = "test_share.XXXXXX";

static void enter_folder(void)
{
    strcpy(folder + sizeof folder - 7, "XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(folder));
    ck_assert_int_eq(chdir(folder), 0);
}

static void leave_folder(void)
{
    remove(PATH);
    ck_assert_int_eq(chdir(".."), 0);
    ck_assert_int_eq(rmdir(folder), 0);
}

/* Files as bytes. */

typedef struct {
    size_t size;
    uint8_t bytes[20000];
} blob;

static blob contents(void)
{
    blob all;
    FILE *file = fopen(PATH, "rb");
    ck_assert_ptr_nonnull(file);
    all.size = fread(all.bytes, 1, sizeof all.bytes, file);
    ck_assert(all.size < sizeof all.bytes);
    fclose(file);
    return all;
}

static void put(const void *bytes, size_t size)
{
    FILE *file = fopen(PATH, "wb");
    ck_assert_ptr_nonnull(file);
    ck_assert_uint_eq(fwrite(bytes, 1, size, file), size);
    ck_assert_int_eq(fclose(file), 0);
}

/* Puts the right hash behind the bytes. */
static void seal(blob *all)
{
    uint64_t hash = UINT64_C(14695981039346656037);
    for (size_t i = 0; i < all->size; i++)
        hash = (hash ^ all->bytes[i]) * UINT64_C(1099511628211);
    for (int i = 0; i < 8; i++)
        all->bytes[all->size++] = (uint8_t)(hash >> 8 * i);
}

static partial_film read_well(void)
{
    partial_film read;
    ck_assert(partial_film_read(PATH, stderr, &read));
    return read;
}

/* One line that names the file and holds `word`; nothing is left allocated. */
static void assert_refused(const char *word, const char *what)
{
    partial_film read;
    char *said = NULL;
    size_t size;
    FILE *messages = open_memstream(&said, &size);
    ck_assert_ptr_nonnull(messages);
    bool done = partial_film_read(PATH, messages, &read);
    fclose(messages);
    ck_assert_msg(!done, "%s was read", what);
    ck_assert_ptr_null(read.scene);
    ck_assert_ptr_null(read.ranges);
    ck_assert_ptr_null(read.sums.pixels);
    ck_assert_msg(strncmp(said, PATH ":", strlen(PATH) + 1) == 0 && strstr(said, " error: ") &&
                      strchr(said, '\n') == said + size - 1,
                  "%s: said %s", what, said);
    ck_assert_msg(strstr(said, word) != NULL, "%s: '%s' is not in: %s", what, word, said);
    free(said);
}

/* Shares. */

static partial_film made(int width, int height)
{
    partial_film of = {.scene = strdup("a scene.rt"),
                       .hash = UINT64_C(0x0123456789abcdef),
                       .options = rt_default_options(),
                       .tier = SURE_TIER_CERTAIN,
                       .how = {.seed = 7, .bounces = 16, .aperture = 0.1}};
    ck_assert_ptr_nonnull(of.scene);
    of.options.width = width;
    of.options.height = height;
    ck_assert(film_new(width, height, &of.sums));
    return of;
}

/* Photons of these numbers, with a share of the light that numbers alone decide. */
static void trace(partial_film *of, uint64_t first, uint64_t end)
{
    int width = of->sums.width, height = of->sums.height;
    for (uint64_t i = first; i < end; i++) {
        int column = suite_integer(1, i, 1 << 20) & 0xffff, row = (int)(suite_bits(2, i) % 7919);
        double value = suite_double(3, i, 12);
        film_add(&of->sums, column % width, row % height, (sure_vec3){value, 2 * value, -value});
        sure_forward_statistics one = {.emitted = 1, .escaped = 1};
        if (i % 3 == 0)
            one = (sure_forward_statistics){.emitted = 1, .absorbed = 1, .lit = 2, .through = 1};
        if (i % 5 == 0)
            one = (sure_forward_statistics){.emitted = 1, .stopped = 1, .through = 2, .reached = 1};
        if (i % 7 == 0)
            one = (sure_forward_statistics){.emitted = 1, .entered = 1, .through = 1, .reached = 1};
        sure_forward_statistics_add(&of->statistics, &one);
    }
    ck_assert(partial_film_add_range(of, (photon_range){first, end}));
}

static void write_well(const partial_film *of)
{
    ck_assert(partial_film_write(of, PATH, stderr));
}

/* Four pixels, of which the second is not dark, byte by byte as the format is described. */
static const char head[] = "surehit share 1\n"
                           "scene a scene.rt\n"
                           "hash 0123456789abcdef\n"
                           "size 2x2\n"
                           "tier certain\n"
                           "handedness right\n"
                           "fov horizontal\n"
                           "cylinder-position middle\n"
                           "cone-position middle\n"
                           "falloff none\n"
                           "skip-unknown no\n"
                           "seed 7\n"
                           "bounces 16\n"
                           "aperture 0x1.999999999999ap-4\n"
                           "ranges 2\n"
                           "photons 3 2\n"
                           "photons 9 4\n"
                           "ended escaped 1 absorbed 2 stopped 3 entered 0\n"
                           "light lit 5 through 4 reached 3\n"
                           "pixels\n";
static const uint8_t light[] = {0x01, 0x01,                               /* one dark pixel */
                                0x05, 0x00, 0x00, 0x00, 0x00, 0x01,       /* red 1 */
                                0x00, 0x01, 0x80, 0x00, 0x02, 0x01, 0x02, /* and no others */
                                0x10, 0,    0,    0,    0,    0,    0,    0, 0,
                                0,    0,    0,    0,    0,    0,    0,    1, /* the most */
                                0x01, 0x02}; /* dark ones at the end */

static blob small(void)
{
    blob all = {.size = 0};
    memcpy(all.bytes, head, sizeof head - 1);
    memcpy(all.bytes + sizeof head - 1, light, sizeof light);
    all.size = sizeof head - 1 + sizeof light;
    return all;
}

START_TEST(a_file_byte_by_byte)
{
    blob expected = small();
    seal(&expected);
    put(expected.bytes, expected.size);
    partial_film of = read_well();
    ck_assert_str_eq(of.scene, "a scene.rt");
    ck_assert_uint_eq(of.hash, UINT64_C(0x0123456789abcdef));
    ck_assert(of.options.width == 2 && of.options.height == 2);
    ck_assert(of.tier == SURE_TIER_CERTAIN && of.how.seed == 7 && of.how.bounces == 16);
    ck_double_same(of.how.aperture, 0.1);
    ck_assert_uint_eq(of.range_count, 2);
    ck_assert(of.ranges[0].first == 3 && of.ranges[0].end == 5);
    ck_assert(of.ranges[1].first == 9 && of.ranges[1].end == 13);
    const sure_forward_statistics *sum = &of.statistics;
    ck_assert(sum->emitted == 6 && sum->escaped == 1 && sum->absorbed == 2 && sum->stopped == 3);
    ck_assert(sum->entered == 0 && sum->lit == 5 && sum->through == 4 && sum->reached == 3);
    const film_pixel *pixel = of.sums.pixels;
    ck_assert(pixel[1].value[0].low == UINT64_C(1) << 32 && pixel[1].value[0].high == 0);
    ck_assert(pixel[1].value[1].low == 0 && pixel[1].value[2].low == 0x80);
    ck_assert(pixel[1].square[0].low == 0 && pixel[1].square[1].low == 0x0201);
    ck_assert(pixel[1].square[2].low == 0 && pixel[1].square[2].high == UINT64_C(1) << 56);
    film_pixel dark = {0};
    for (int i = 0; i < 4; i++)
        ck_assert(i == 1 || memcmp(&pixel[i], &dark, sizeof dark) == 0);
    write_well(&of);
    blob again = contents();
    ck_assert_uint_eq(again.size, expected.size);
    ck_assert_mem_eq(again.bytes, expected.bytes, expected.size);
    partial_film_free(&of);
}
END_TEST

static void assert_same(const partial_film *a, const partial_film *b)
{
    ck_assert_ptr_null(partial_film_difference(a, b));
    ck_assert_str_eq(a->scene, b->scene);
    ck_assert_uint_eq(a->range_count, b->range_count);
    if (a->range_count > 0)
        ck_assert_mem_eq(a->ranges, b->ranges, a->range_count * sizeof *a->ranges);
    ck_assert_mem_eq(&a->statistics, &b->statistics, sizeof a->statistics);
    ck_assert_mem_eq(a->sums.pixels, b->sums.pixels,
                     (size_t)(a->sums.width * a->sums.height) * sizeof *a->sums.pixels);
}

START_TEST(round_trips)
{
    static const int sizes[][2] = {{1, 1}, {7, 3}, {64, 1}, {5, 40}};
    static const uint64_t photons[] = {1, 2, 5, 300};
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            partial_film of = made(sizes[i][0], sizes[i][1]);
            of.options.cone_position = RT_POSITION_APEX;
            of.options.falloff = SURE_FALLOFF_INVERSE_SQUARE;
            of.options.skip_unknown = j % 2 == 0;
            of.how.seed = UINT64_MAX;
            of.tier = SURE_TIER_FLOAT32;
            trace(&of, 100, 100 + photons[j]);
            trace(&of, PHOTONS_MOST - photons[j], PHOTONS_MOST);
            write_well(&of);
            partial_film read = read_well();
            assert_same(&of, &read);
            partial_film_free(&read);
            partial_film_free(&of);
        }
    }
}
END_TEST

START_TEST(what_is_cut_off)
{
    blob all = small();
    seal(&all);
    for (size_t size = 0; size < all.size; size++) {
        put(all.bytes, size);
        assert_refused(size < sizeof head - 1 ? PATH ":" : PATH ": error: byte", "a part");
    }
    all.bytes[all.size] = 0;
    put(all.bytes, all.size + 1);
    assert_refused("something follows", "more");
}
END_TEST

START_TEST(what_is_damaged)
{
    blob all = small();
    seal(&all);
    for (size_t i = 0; i < all.size; i++) {
        blob other = all;
        other.bytes[i] ^= (uint8_t)(1 << i % 8);
        put(other.bytes, other.size);
        assert_refused("", "a damaged one");
    }
}
END_TEST

/* The lines from `right` on become `wrong`, and the hash is right. */
static void forge(const char *right, const char *wrong)
{
    blob all = {.size = 0};
    const char *at = strstr(head, right);
    ck_assert_msg(at != NULL, "%s", right);
    all.size = (size_t)(at - head);
    memcpy(all.bytes, head, all.size);
    memcpy(all.bytes + all.size, wrong, strlen(wrong));
    all.size += strlen(wrong);
    strcpy((char *)all.bytes + all.size, at + strlen(right));
    all.size += strlen(at + strlen(right));
    memcpy(all.bytes + all.size, light, sizeof light);
    all.size += sizeof light;
    seal(&all);
    put(all.bytes, all.size);
}

START_TEST(forged_headers)
{
    static const struct {
        const char *right, *wrong, *said;
    } cases[] = {
        {"share 1", "share 2", ":1: error: expected 'surehit share 1'"},
        {"surehit share 1\n", "P6\n", ":1: error: expected"},
        {"scene a scene.rt\n", "", ":2: error: expected 'scene'"},
        {"hash 0123456789abcdef", "hash 0123456789abcdefg", ":3:"},
        {"hash 0123456789abcdef", "hash 10123456789abcdef", ":3:"},
        {"size 2x2", "size 0x2", ":4: error: size '0x2'"},
        {"size 2x2", "size 65536x2", ":4:"},
        {"size 2x2", "size 2x2 ", ":4:"},
        {"size 2x2", "size 2x1", "the hash is another"},
        {"size 2x2", "size 2x3", ": error: byte "},
        {"size 2x2", "size 65535x65535", ": error: byte "},
        {"tier certain", "tier surely", ":5: error: expected a tier"},
        {"handedness right", "handedness up", ":6:"},
        {"skip-unknown no", "skip-unknown maybe", ":11:"},
        {"seed 7", "seed -7", ":12: error: expected a number of seed"},
        {"seed 7", "seed 18446744073709551616", ":12:"},
        {"bounces 16", "bounces 0", ":13:"},
        {"bounces 16", "bounces 2147483648", ":13:"},
        {"aperture 0x1.999999999999ap-4", "aperture 0.1", ":14:"},
        {"aperture 0x1.999999999999ap-4", "aperture -0x1p-4", ":14:"},
        {"aperture 0x1.999999999999ap-4", "aperture inf", ":14:"},
        {"aperture 0x1.999999999999ap-4", "aperture 0x1p+2000", ":14:"},
        {"ranges 2", "ranges 0", ":15: error: no photons"},
        {"ranges 2", "ranges 1", ":17: error: expected 'ended'"},
        {"ranges 2", "ranges 3", ":18: error: expected 'photons'"},
        {"ranges 2", "ranges 72057594037927936", ":18: error: expected 'photons'"},
        {"ranges 2", "ranges 72057594037927937", ":15:"},
        {"photons 3 2", "photons 3 0", ":16:"},
        {"photons 3 2", "photons 3", ":16:"},
        {"photons 3 2", "photons 3 2 1", ":16: error: expected two"},
        {"photons 3 2", "photons 3 6", ":17: error: photons that don't"},
        {"photons 3 2", "photons 9 2", ":17: error: photons that don't"},
        {"photons 9 4", "photons 72057594037927935 4", ":17:"},
        {"photons 9 4", "photons 9 5", ":18: error: fewer"},
        {"photons 9 4", "photons 9 3", ":18: error: more"},
        {"escaped 1", "escaped 2", ":18: error: more"},
        {"escaped 1", "escaped 0", ":18: error: fewer"},
        {"stopped 3 entered 0", "stopped 3", ":18: error: expected 'entered'"},
        {"entered 0", "entered 0 lost 0", ":18: error: expected no more"},
        {"reached 3", "reached 5", ":19: error: more has reached"},
        {"pixels\n", "pixels of light\n", ":20:"},
        {"pixels\n", "", ":20: error: "},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        forge(cases[i].right, cases[i].wrong);
        assert_refused(cases[i].said, cases[i].wrong);
    }
}
END_TEST

/* Instead of the light. */
START_TEST(forged_pixels)
{
    static const struct {
        const char *bytes;
        size_t size;
        const char *said;
    } cases[] = {
        {"\x01\x05", 2, "more pixels than the picture has"},
        {"\x09\0\0\0\0\0\0\0\0\x01", 10, "more pixels than the picture has"},
        {"\x01\x01\x01\x03\0\0\0\0\0\x01\x03", 11, "more pixels than the picture has"},
        {"\x11", 1, "more than 16 bytes"},
        {"\xff", 1, "more than 16 bytes"},
        {"\x01\x00", 2, "a byte too many"},
        {"\x02\x03\x00", 3, "a byte too many"},
        {"\x01\x03\x00\x00\x00\x00\x00\x00", 8, "a dark pixel"},
        {"\x00\x00\x00\x00\x00\x00\x00", 7, "a dark pixel"},
        {"\x01\x03\x01\x01\x00\x00\x00\x00\x00\x00", 10, "the hash is another"},
        {"\x01\x04\x00", 3, "the hash is another"},
        {"", 0, "a number of more than 16 bytes"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        blob all = {.size = sizeof head - 1};
        memcpy(all.bytes, head, all.size);
        memcpy(all.bytes + all.size, cases[i].bytes, cases[i].size);
        all.size += cases[i].size;
        seal(&all);
        put(all.bytes, all.size);
        assert_refused(cases[i].said, cases[i].said);
    }
}
END_TEST

START_TEST(no_file)
{
    assert_refused("No such file", "nothing");
    put("", 0);
}
END_TEST

/* Sums. */

/* Some photons, cut in `parts` of which each is traced alone. */
static void cut(partial_film parts[], int count, uint64_t photons)
{
    uint64_t first = 0;
    for (int i = 0; i < count; i++) {
        uint64_t end = i + 1 < count ? first + suite_bits(50, (uint64_t)i) % (photons / 4) + 1
                                     : first + photons / 2;
        parts[i] = made(9, 5);
        trace(&parts[i], first, end);
        first = end;
    }
}

START_TEST(any_order_and_grouping)
{
    partial_film parts[7];
    blob expected = {.size = 0};
    cut(parts, 7, 400);
    parts[3].scene[0] = 'Z'; /* before the others' */
    for (uint64_t turn = 0; turn < 60; turn++) {
        partial_film sum[7];
        for (int i = 0; i < 7; i++) {
            ck_assert(partial_film_begin(&parts[i], &sum[i]));
            ck_assert(partial_film_add(&sum[i], &parts[i]));
        }
        /* One of those that are left is added to another one, until one is left. */
        for (uint64_t left = 7; left > 1; left--) {
            uint64_t from = suite_bits(60 + turn, left) % left;
            uint64_t to = suite_bits(160 + turn, left) % (left - 1);
            to += to >= from;
            photon_range both;
            ck_assert_ptr_null(partial_film_difference(&sum[to], &sum[from]));
            ck_assert(!partial_film_overlap(&sum[to], &sum[from], &both));
            ck_assert(partial_film_add(&sum[to], &sum[from]));
            ck_assert(partial_film_overlap(&sum[to], &sum[from], &both));
            partial_film_free(&sum[from]);
            if (to == left - 1)
                to = from;
            sum[from] = sum[left - 1];
        }
        write_well(&sum[0]);
        ck_assert_uint_eq(sum[0].range_count, 1);
        partial_film_free(&sum[0]);
        blob now = contents();
        if (turn == 0)
            expected = now;
        ck_assert_uint_eq(now.size, expected.size);
        ck_assert_mem_eq(now.bytes, expected.bytes, now.size);
    }
    partial_film whole = made(9, 5);
    whole.scene[0] = 'Z';
    trace(&whole, parts[0].ranges[0].first, parts[6].ranges[0].end);
    write_well(&whole);
    blob now = contents();
    ck_assert_uint_eq(now.size, expected.size);
    ck_assert_mem_eq(now.bytes, expected.bytes, now.size);
    partial_film_free(&whole);
    for (int i = 0; i < 7; i++)
        partial_film_free(&parts[i]);
}
END_TEST

/* Ranges as bits of a number. */
static uint64_t bits_of(const partial_film *of)
{
    uint64_t bits = 0;
    for (size_t i = 0; i < of->range_count; i++) {
        ck_assert(of->ranges[i].first < of->ranges[i].end);
        ck_assert(i == 0 || of->ranges[i - 1].end < of->ranges[i].first);
        for (uint64_t j = of->ranges[i].first; j < of->ranges[i].end; j++)
            bits |= UINT64_C(1) << j;
    }
    return bits;
}

static uint64_t bits_between(uint64_t first, uint64_t end)
{
    uint64_t bits = 0;
    for (uint64_t i = first; i < end; i++)
        bits |= UINT64_C(1) << i;
    return bits;
}

START_TEST(ranges)
{
    for (uint64_t turn = 0; turn < 2000; turn++) {
        partial_film of = {0}, other = {0};
        uint64_t bits = 0, others = 0;
        for (uint64_t i = 0; i < 12; i++) {
            uint64_t first = suite_bits(300 + turn, i) % 24;
            uint64_t end = first + 1 + suite_bits(3000 + turn, i) % 5;
            uint64_t more = bits_between(first, end);
            partial_film *to = i % 3 == 0 ? &other : &of;
            uint64_t *to_bits = i % 3 == 0 ? &others : &bits;
            if (*to_bits & more)
                continue;
            *to_bits |= more;
            ck_assert(partial_film_add_range(to, (photon_range){first, end}));
            ck_assert_uint_eq(bits_of(to), *to_bits);
        }
        photon_range both, gap;
        uint64_t common = bits & others, lowest = common & (~common + 1);
        ck_assert_int_eq(partial_film_overlap(&of, &other, &both), common != 0);
        if (common != 0) {
            ck_assert_uint_eq(UINT64_C(1) << both.first, lowest);
            ck_assert_uint_eq(bits_between(both.first, both.end) & ~common, 0);
        }
        photon_range wanted = {suite_bits(7, turn) % 16, 0};
        wanted.end = wanted.first + suite_bits(8, turn) % 14;
        uint64_t missing = bits_between(wanted.first, wanted.end) & ~bits;
        ck_assert_int_eq(partial_film_gap(&of, wanted, &gap), missing != 0);
        if (missing != 0) {
            ck_assert_uint_eq(UINT64_C(1) << gap.first, missing & (~missing + 1));
            ck_assert_uint_eq(bits_between(gap.first, gap.end) & ~missing, 0);
            ck_assert_uint_eq(missing >> gap.end & 1, 0);
        }
        free(of.ranges);
        free(other.ranges);
    }
}
END_TEST

START_TEST(differences)
{
    partial_film a = made(3, 2), b;
    ck_assert(partial_film_begin(&a, &b));
    ck_assert_ptr_null(partial_film_difference(&a, &b));
    b.scene[0] = 'b'; /* what it is called does not matter */
    ck_assert_ptr_null(partial_film_difference(&a, &b));
#define ASSERT_DIFFERS(field, value, name)                                                         \
    do {                                                                                           \
        partial_film other = b;                                                                    \
        other.field = value;                                                                       \
        ck_assert_str_eq(partial_film_difference(&a, &other), name);                               \
        ck_assert_str_eq(partial_film_difference(&other, &a), name);                               \
    } while (0)
    ASSERT_DIFFERS(hash, 1, "scene");
    ASSERT_DIFFERS(tier, SURE_TIER_EXACT, "tier");
    ASSERT_DIFFERS(how.seed, 8, "seed");
    ASSERT_DIFFERS(how.bounces, 15, "bounces");
    ASSERT_DIFFERS(how.aperture, 0, "aperture");
    ASSERT_DIFFERS(options.width, 4, "size");
    ASSERT_DIFFERS(options.height, 4, "size");
    ASSERT_DIFFERS(options.handedness, RT_LEFT_HANDED, "handedness");
    ASSERT_DIFFERS(options.fov, RT_FOV_VERTICAL, "fov");
    ASSERT_DIFFERS(options.cylinder_position, RT_POSITION_BASE, "cylinder-position");
    ASSERT_DIFFERS(options.cone_position, RT_POSITION_BASE, "cone-position");
    ASSERT_DIFFERS(options.falloff, SURE_FALLOFF_INVERSE_SQUARE, "falloff");
    ASSERT_DIFFERS(options.skip_unknown, true, "skip-unknown");
    partial_film_free(&a);
    partial_film_free(&b);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("share");
    TCase *tests = tcase_create("share");
    tcase_add_checked_fixture(tests, enter_folder, leave_folder);
    tcase_add_test(tests, a_file_byte_by_byte);
    tcase_add_test(tests, round_trips);
    tcase_add_test(tests, what_is_cut_off);
    tcase_add_test(tests, what_is_damaged);
    tcase_add_test(tests, forged_headers);
    tcase_add_test(tests, forged_pixels);
    tcase_add_test(tests, no_file);
    tcase_add_test(tests, any_order_and_grouping);
    tcase_add_test(tests, ranges);
    tcase_add_test(tests, differences);
    suite_add_tcase(suite, tests);
    return suite_run(suite);
}
