/* SPDX-License-Identifier: MIT */
/* Shares in files: what is written is read, whatever else is refused; sums in any order. */
#define _XOPEN_SOURCE 700

#include "../../src/photons/partial_film.h"
#include "../support/files.h"
#include "../support/text_rows.h"

#include <zlib.h>

#define PATH "a.share"

/* Files as bytes, and what is compressed in them. */

typedef struct {
    size_t size;
    uint8_t bytes[30000];
} blob;

static blob unpacked(void)
{
    blob all;
    gzFile file = gzopen(PATH, "rb");
    ck_assert_ptr_nonnull(file);
    all.size = (size_t)gzread(file, all.bytes, sizeof all.bytes);
    ck_assert(all.size < sizeof all.bytes && !gzdirect(file));
    ck_assert_int_eq(gzclose(file), Z_OK);
    return all;
}

static void pack(const blob *all)
{
    gzFile file = gzopen(PATH, "wb");
    ck_assert_ptr_nonnull(file);
    ck_assert_int_eq(gzwrite(file, all->bytes, (unsigned)all->size), (int)all->size);
    ck_assert_int_eq(gzclose(file), Z_OK);
}

static partial_film read_well(void)
{
    partial_film read;
    ck_assert(partial_film_read(PATH, stderr, &read));
    return read;
}

/* Nothing is left allocated. */
static void assert_refused(const char *word, const char *what)
{
    partial_film read;
    FILE *messages = listen();
    ck_assert_msg(!partial_film_read(PATH, messages, &read), "%s was read", what);
    ck_assert_ptr_null(read.ranges.of);
    ck_assert_ptr_null(read.sums.pixels);
    assert_said(messages, PATH, word);
}

/* Shares. */

static partial_film made(int width, int height)
{
    partial_film of = {.hash = UINT64_C(0x0123456789abcdef),
                       .options = rt_default_options(),
                       .tier = SURE_TIER_CERTAIN,
                       .how = {.seed = 7, .bounces = 16, .aperture = 0.1}};
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
    ck_assert(ranges_add(&of->ranges, (index_range){first, end}));
}

static void write_well(const partial_film *of)
{
    ck_assert(partial_film_write(of, PATH, stderr));
}

/* Four pixels, of which the second is not dark, byte by byte as the format is described. */
static const char head[] =
    "{\"surehit share\": 1, \"hash\": \"0123456789abcdef\", \"tier\": \"certain\", \"options\": "
    "{\"size\": \"2x2\", \"camera\": \"1\", \"skip-unknown\": false, \"handedness\": \"right\", "
    "\"fov\": \"horizontal\", \"cylinder-position\": \"middle\", "
    "\"cone-position\": \"middle\", \"falloff\": \"none\", \"dialect\": \"strict\"}, "
    "\"seed\": \"fedcba9876543210\", \"bounces\": 16, \"aperture\": 0.10000000000000001, "
    "\"ranges\": [[3, 2], [9, 4]], \"counts\": {\"photons\": 6, \"escaped\": 1, "
    "\"absorbed\": 2, \"stopped\": 3, \"entered\": 0, \"lit\": 5, \"through\": 4, "
    "\"reached\": 3}}\n";
enum { PIXEL = 96 };
/* Red 1, some blue, squares of green and of blue. */
static const uint8_t light[4 * PIXEL] = {
    [PIXEL + 4] = 1, [PIXEL + 32] = 0x80, [PIXEL + 64] = 1, [PIXEL + 65] = 2, [PIXEL + 95] = 1};

static blob share_of(const char *header, size_t size, const void *pixels, size_t more)
{
    blob all = {.size = size + more};
    memcpy(all.bytes, header, size);
    memcpy(all.bytes + size, pixels, more);
    return all;
}

static blob small(void)
{
    return share_of(head, sizeof head - 1, light, sizeof light);
}

static void assert_same(const partial_film *a, const partial_film *b)
{
    ck_assert_ptr_null(partial_film_difference(a, b));
    ck_assert_uint_eq(a->ranges.count, b->ranges.count);
    if (a->ranges.count > 0)
        ck_assert_mem_eq(a->ranges.of, b->ranges.of, a->ranges.count * sizeof *a->ranges.of);
    ck_assert_mem_eq(&a->statistics, &b->statistics, sizeof a->statistics);
    ck_assert_mem_eq(a->sums.pixels, b->sums.pixels,
                     (size_t)(a->sums.width * a->sums.height) * sizeof *a->sums.pixels);
}

TEST(a_file_byte_by_byte)
{
    index_range ranges[] = {{3, 5}, {9, 13}};
    film_pixel pixels[4] = {
        [1] = {.value = {(film_sum)1 << 32, 0, 0x80}, .square = {0, 0x0201, (film_sum)1 << 120}}};
    const partial_film expected = {
        .hash = UINT64_C(0x0123456789abcdef),
        .options = {.width = 2, .height = 2, .camera = 1},
        .tier = SURE_TIER_CERTAIN,
        .how = {.seed = UINT64_C(0xfedcba9876543210), .bounces = 16, .aperture = 0.1},
        .ranges = {ranges, 2},
        .statistics = {6, 1, 2, 3, 0, 5, 4, 3},
        .sums = {2, 2, pixels}};
    const blob all = small();
    pack(&all);
    FREED_BY(partial_film_free) partial_film of = read_well();
    assert_same(&of, &expected);
    write_well(&of);
    blob again = unpacked();
    ck_assert_uint_eq(again.size, all.size);
    ck_assert_mem_eq(again.bytes, all.bytes, all.size);
}

TEST(round_trips)
{
    static const int sizes[][2] = {{1, 1}, {7, 3}, {64, 1}, {5, 40}};
    static const uint64_t photons[] = {1, 2, 5, 300};
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            FREED_BY(partial_film_free) partial_film of = made(sizes[i][0], sizes[i][1]);
            of.options.cone_position = RT_POSITION_APEX;
            of.options.falloff = SURE_FALLOFF_INVERSE_SQUARE;
            of.options.skip_unknown = j % 2 == 0;
            of.how.seed = UINT64_MAX;
            of.tier = SURE_TIER_FLOAT32;
            trace(&of, 100, 100 + photons[j]);
            trace(&of, RANGES_MOST - photons[j], RANGES_MOST);
            write_well(&of);
            FREED_BY(partial_film_free) partial_film read = read_well();
            assert_same(&of, &read);
        }
    }
}

TEST(what_is_cut_off)
{
    const blob all = small();
    size_t whole;
    pack(&all);
    FREED_BY(free_text) char *packed = (char *)get(PATH, &whole);
    for (size_t size = 0; size < whole; size++) {
        put(PATH, packed, size);
        assert_refused("", "a part");
    }
    put(PATH, all.bytes, all.size);
    assert_refused("no share", "what is not compressed");
}

/* A bit that no decompressor looks at, as that of a date, changes nothing. */
TEST(what_is_damaged)
{
    const blob all = small();
    int harmless = 0;
    size_t size;
    pack(&all);
    uint8_t *packed = get(PATH, &size);
    partial_film right = read_well(), read;
    for (size_t i = 0; i < size; i++) {
        const uint8_t bit = (uint8_t)(1 << i % 8);
        packed[i] ^= bit;
        put(PATH, packed, size);
        packed[i] ^= bit;
        FILE *unheard = listen();
        if (partial_film_read(PATH, unheard, &read)) {
            harmless++;
            assert_same(&read, &right);
            partial_film_free(&read);
        }
        fclose(unheard);
    }
    free(packed);
    ck_assert_int_le(harmless, 10);
    partial_film_free(&right);
}

/* Packed as it should be: a piece of the header is another. */
TEST(forged_headers)
{
    FILE *file = rows_open("photons/forged_shares.txt");
    char right[200];
    int count = 0;
    for (; rows_line(file, right, sizeof right); count++) {
        char *wrong = row_cut(right, " -> "), *said = row_cut(wrong, " ; "),
             header[sizeof head + 100];
        const char *at = strstr(head, right);
        ck_assert_msg(at != NULL, "%s", right);
        int size = snprintf(header, sizeof header, "%.*s%s%s", (int)(at - head), head, wrong,
                            at + strlen(right));
        const blob all = share_of(header, (size_t)size, light, sizeof light);
        said[strcspn(said, "\n")] = '\0';
        pack(&all);
        assert_refused(said, wrong);
    }
    fclose(file);
    ck_assert_int_ge(count, 53);
}

TEST(more_or_fewer_pixels)
{
    const uint8_t more[sizeof light + 1] = {0};
    for (size_t size = 0; size <= sizeof more; size++) {
        const blob all = share_of(head, sizeof head - 1, more, size);
        pack(&all);
        if (size != sizeof light)
            assert_refused(size < sizeof light ? "ends too early" : "something follows", "pixels");
    }
}

/* Behind what is compressed: bytes, or another share. */
TEST(more_in_the_file)
{
    const blob all = small();
    size_t size;
    pack(&all);
    FREED_BY(free_text) char *packed = (char *)get(PATH, &size);
    char *more = malloc(size + 40000);
    memcpy(more, packed, size);
    memset(more + size, 0, 40000);
    for (size_t length = 1; length <= 40000; length = 3 * length + 1) {
        put(PATH, more, size + length);
        assert_refused("something follows where the share ends", "zeros");
    }
    memcpy(more + size, packed, size);
    put(PATH, more, 2 * size);
    assert_refused("something follows where the share ends", "two shares");
    free(more);
}

TEST(no_file)
{
    assert_refused("No such file", "nothing");
}

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

TEST(any_order_and_grouping)
{
    partial_film parts[7];
    uint8_t *expected = NULL;
    size_t size = 0;
    cut(parts, 7, 400);
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
            index_range both;
            ck_assert_ptr_null(partial_film_difference(&sum[to], &sum[from]));
            ck_assert(!ranges_overlap(&sum[to].ranges, &sum[from].ranges, &both));
            ck_assert(partial_film_add(&sum[to], &sum[from]));
            ck_assert(ranges_overlap(&sum[to].ranges, &sum[from].ranges, &both));
            partial_film_free(&sum[from]);
            sum[from] = sum[left - 1];
        }
        write_well(&sum[0]);
        ck_assert_uint_eq(sum[0].ranges.count, 1);
        partial_film_free(&sum[0]);
        if (turn == 0)
            expected = get(PATH, &size);
        assert_holds(PATH, expected, size);
    }
    FREED_BY(partial_film_free) partial_film whole = made(9, 5);
    trace(&whole, parts[0].ranges.of[0].first, parts[6].ranges.of[0].end);
    write_well(&whole);
    assert_holds(PATH, expected, size);
    free(expected);
    for (int i = 0; i < 7; i++)
        partial_film_free(&parts[i]);
}

/* Ranges as bits of a number. */
static uint64_t bits_of(const partial_film *of)
{
    uint64_t bits = 0;
    for (size_t i = 0; i < of->ranges.count; i++) {
        ck_assert(of->ranges.of[i].first < of->ranges.of[i].end);
        ck_assert(i == 0 || of->ranges.of[i - 1].end < of->ranges.of[i].first);
        for (uint64_t j = of->ranges.of[i].first; j < of->ranges.of[i].end; j++)
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

TEST(ranges_as_bits)
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
            ck_assert(ranges_add(&to->ranges, (index_range){first, end}));
            ck_assert_uint_eq(bits_of(to), *to_bits);
        }
        index_range both, gap;
        uint64_t common = bits & others, lowest = common & (~common + 1);
        ck_assert_int_eq(ranges_overlap(&of.ranges, &other.ranges, &both), common != 0);
        if (common != 0) {
            ck_assert_uint_eq(UINT64_C(1) << both.first, lowest);
            ck_assert_uint_eq(bits_between(both.first, both.end) & ~common, 0);
        }
        index_range wanted = {suite_bits(7, turn) % 16, 0};
        wanted.end = wanted.first + suite_bits(8, turn) % 14;
        uint64_t missing = bits_between(wanted.first, wanted.end) & ~bits;
        ck_assert_int_eq(ranges_gap(&of.ranges, wanted, &gap), missing != 0);
        if (missing != 0) {
            ck_assert_uint_eq(UINT64_C(1) << gap.first, missing & (~missing + 1));
            ck_assert_uint_eq(bits_between(gap.first, gap.end) & ~missing, 0);
            ck_assert_uint_eq(missing >> gap.end & 1, 0);
        }
        free(of.ranges.of);
        free(other.ranges.of);
    }
}

TEST(differences)
{
    FREED_BY(partial_film_free) partial_film a = made(3, 2), b;
    ck_assert(partial_film_begin(&a, &b));
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
    ASSERT_DIFFERS(options.dialect, RT_42, "dialect");
    ASSERT_DIFFERS(options.camera, 2, "camera");
}

SUITE_IN("share", enter_folder, leave_folder)
