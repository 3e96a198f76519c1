/* SPDX-License-Identifier: MIT */
#include "options.h"

#include "../image/difference.h"
#include "../support/complain.h"
#include "../support/json_file.h"

#include <stdio.h>

#define EXIT_DIFFERENT 1

static const char *output, *json;

static bool write_picture(const picture pair[2], const difference *found)
{
    picture shown;
    if (output && !found->same_size) {
        printable_printf(stderr, "%s: not written: the pictures differ in size", output);
        fputc('\n', stderr);
    }
    if (!output || !found->same_size)
        return true;
    if (!difference_draw(&pair[0], &pair[1], &shown))
        return complain(stderr, output, "no memory for this picture");
    bool written = picture_write(&shown, output, stderr);
    picture_free(&shown);
    return written;
}

static int compare(const picture pair[2])
{
    difference found = difference_of(&pair[0], &pair[1]);
    bool same = difference_is_none(&found);
    FILE *words = output && picture_is_stdout(output) ? stderr : stdout;
    printable_printf(words, "%s and %s %s", cli_operands[0], cli_operands[1],
                     same ? "are the same" : "differ: ");
    if (!same)
        difference_print(words, &found);
    fputc('\n', words);
    bool written = json_write_file(difference_json(&found), json, stderr);
    written = write_picture(pair, &found) && written;
    return !written ? EXIT_TROUBLE : same ? 0 : EXIT_DIFFERENT;
}

static int run(void)
{
    picture pair[2] = {{0}, {0}};
    const char *outputs[] = {output && picture_is_stdout(output) ? NULL : output, json};
    const cli_paths all = {outputs, cli_operands, 2, 2};
    if ((output && !picture_path_ok(output, stderr)) || cli_paths_check(&all) != 0)
        return EXIT_TROUBLE;
    bool read = picture_read(cli_operands[0], stderr, &pair[0]);
    read = picture_read(cli_operands[1], stderr, &pair[1]) && read;
    int status = read ? compare(pair) : EXIT_TROUBLE;
    picture_free(&pair[0]);
    picture_free(&pair[1]);
    return status;
}

static const cli_option options[] = {
    {"o", "FILE",
     "the difference as a picture: what is the same grey and dim, from A; what differs orange, "
     "the brighter the more",
     cli_text, .to = &output},
    {"json", "FILE", "what is said, for programs", cli_text, .to = &json},
    {0},
};

const cli_command command_diff = {
    .name = "surehit diff",
    .summary = "say where two pictures differ",
    .usage = "A B [-o D.ppm|D.png] [--json FILE]",
    .about = "Says where two pictures differ: how many pixels, by how much at most in a\n"
             "channel, and the smallest box that holds them (x, y, w, h; the origin is the\n"
             "upper left corner). A picture is a P6 PPM of 255 levels, or a PNG of up to 8\n"
             "bits a channel and without transparency, whatever its name.",
    .options = options,
    .operands = "A B",
    .most_operands = 2,
    .statuses = "0 the same; 1 different; 2 wrong usage, a picture that can't be\n"
                "read, or output that could not be written.",
    .lost = EXIT_TROUBLE,
    .run = run,
};
