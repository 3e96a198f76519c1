/* SPDX-License-Identifier: MIT */
#include "regress.h"
#include "../support/atomic_file.h"
#include "../support/base64.h"
#include "../support/complain.h"
#include "../support/markup.h"

#include <stdlib.h>
#include <string.h>

extern const char regress_style[]; /* page.css; each text has a contrast of 4.5 (test_regress.py) */

bool regress_page_open(regress_page *page)
{
    *page = (regress_page){0};
    page->parts = open_memstream(&page->parts_text, &page->parts_size);
    page->same = open_memstream(&page->same_text, &page->same_size);
    if (page->parts && page->same)
        return true;
    regress_page_close(page);
    return false;
}

void regress_page_close(regress_page *page)
{
    if (page->parts)
        fclose(page->parts);
    if (page->same)
        fclose(page->same);
    free(page->parts_text);
    free(page->same_text);
    *page = (regress_page){0};
}

static void print_png(regress_page *page, const picture *image)
{
    char *bytes = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&bytes, &size);
    bool written = stream && picture_write_png(image, stream, "the page", stderr);
    char *text = stream && fclose(stream) == 0 && written ? base64_of(bytes, size) : NULL;
    if (text)
        fputs(text, page->parts);
    else
        page->failed = true;
    free(text);
    free(bytes);
}

/* Below that width a picture is shown enlarged, as a rule. */
#define SMALL 480

/* A tap on it, or a blank, shows it in its own size. `marked` is the part that gets a frame; NULL:
 * none. */
static void print_figure(regress_page *page, const char *title, const picture *image,
                         const pixel_box *marked)
{
    fprintf(page->parts,
            "<figure><figcaption>%s</figcaption><label>"
            "<input type=checkbox aria-label='%s in its own size'><span class=framed>"
            "<img width=%d height=%d class=%s alt='%s' src='data:image/png;base64,",
            title, title, image->width, image->height, image->width < SMALL ? "small" : "large",
            title);
    print_png(page, image);
    fputs("'>", page->parts);
    if (marked)
        fprintf(page->parts, "<i style='left:%.3f%%;top:%.3f%%;width:%.3f%%;height:%.3f%%'></i>",
                100.0 * marked->left / image->width, 100.0 * marked->top / image->height,
                100.0 * marked->width / image->width, 100.0 * marked->height / image->height);
    fputs("</span></label></figure>\n", page->parts);
}

/* The box, with something to see beside it. */
#define MARGIN 4
#define LEAST_SIDE 24

/* `size` pixels from *start on, widened, of the `all` that there are: returns how many. */
static int widened(int *start, int size, int all)
{
    int side = size + 2 * MARGIN > LEAST_SIDE ? size + 2 * MARGIN : LEAST_SIDE;
    side = side < all ? side : all;
    *start += size / 2 - side / 2;
    *start = *start > all - side ? all - side : *start > 0 ? *start : 0;
    return side;
}

static pixel_box surroundings(const pixel_box *box, const picture *of)
{
    pixel_box part = *box;
    part.width = widened(&part.left, box->width, of->width);
    part.height = widened(&part.top, box->height, of->height);
    return part;
}

static void print_cut(regress_page *page, const char *title, const picture *from,
                      const pixel_box *part)
{
    picture cut;
    if (!picture_new(part->width, part->height, &cut)) {
        page->failed = true;
        return;
    }
    size_t row_size = 3 * (size_t)part->width;
    for (int row = 0; row < part->height; row++) {
        size_t from_pixel = (size_t)(part->top + row) * (size_t)from->width + (size_t)part->left;
        memcpy(cut.rgb + (size_t)row * row_size, from->rgb + 3 * from_pixel, row_size);
    }
    print_figure(page, title, &cut, NULL);
    picture_free(&cut);
}

/* One pixel of a large picture is hard to find: what differs is framed, and where it is small shown
 * again by itself. */
static void print_difference(regress_page *page, const regression *found)
{
    picture shown;
    const pixel_box *box = &found->apart.box;
    if (!difference_draw(&found->golden, &found->got, &shown)) {
        page->failed = true;
        return;
    }
    print_figure(page, "difference", &shown, box);
    pixel_box part = surroundings(box, &shown);
    if (2 * part.width <= shown.width) {
        print_cut(page, "expected, enlarged", &found->golden, &part);
        print_cut(page, "got, enlarged", &found->got, &part);
        print_cut(page, "difference, enlarged", &shown, &part);
    }
    picture_free(&shown);
}

static void print_pictures(regress_page *page, const regression *found)
{
    if (!found->golden.rgb && !found->got.rgb)
        return;
    fputs("<div class=pictures>\n", page->parts);
    if (found->golden.rgb)
        print_figure(page, "expected", &found->golden, NULL);
    if (found->got.rgb)
        print_figure(page, "got", &found->got, NULL);
    if (found->verdict == REGRESS_DIFFERS && found->apart.same_size)
        print_difference(page, found);
    fputs("</div>\n", page->parts);
}

static void add_part(regress_page *page, const char *name, const regression *found,
                     const char *remark)
{
    fputs("<section><h2>", page->parts);
    markup_print(page->parts, name);
    fprintf(page->parts, "</h2>\n<p><b class=%s>", found->verdict == REGRESS_NEW ? "new" : "wrong");
    regress_print_verdict(page->parts, found);
    fprintf(page->parts, "</b>%s%s</p>\n", remark ? "; " : "", remark ? remark : "");
    if (found->messages[0] != '\0') {
        fputs("<pre>", page->parts);
        markup_print(page->parts, found->messages);
        fputs("</pre>\n", page->parts);
    }
    print_pictures(page, found);
    fputs("</section>\n", page->parts);
}

void regress_page_add(regress_page *page, const char *name, const regression *found,
                      const char *remark)
{
    if (found->verdict != REGRESS_SAME) {
        add_part(page, name, found, remark);
        return;
    }
    fputs(page->same_size > 0 ? ", " : "", page->same);
    markup_print(page->same, name);
    fflush(page->same);
}

static void print_page(FILE *out, const regress_page *page, const char *folder,
                       const render_settings *settings, const int counts[REGRESS_VERDICTS])
{
    fputs("<!doctype html>\n<html lang=en>\n<head>\n<meta charset=utf-8>\n"
          "<meta name=viewport content='width=device-width,initial-scale=1'>\n"
          "<title>surehit regress: ",
          out);
    markup_print(out, folder);
    fprintf(out, "</title>\n%s</head>\n<body>\n<h1>", regress_style);
    markup_print(out, folder);
    fputs("</h1>\n<p>", out);
    regress_print_counts(out, counts);
    fprintf(out, ".</p>\n<p class=soft>Tier %s", sure_tier_name(settings->how.tier));
    if (settings->reading_set & RT_SET(RT_SIZE))
        fprintf(out, ", %dx%d pixels", settings->reading.width, settings->reading.height);
    fputs(". Expected is the golden picture, got is what is drawn now. In a difference what is the "
          "same is dim and what differs orange, the brighter the more. A tap on a picture shows it "
          "in its own size.</p>\n",
          out);
    fwrite(page->parts_text, 1, page->parts_size, out);
    if (page->same_size > 0)
        fprintf(out, "<h2>The same</h2>\n<p>%s</p>\n", page->same_text);
    fputs("</body>\n</html>\n", out);
}

bool regress_page_write(regress_page *page, const char *folder, const render_settings *settings,
                        const int counts[REGRESS_VERDICTS], const char *path)
{
    atomic_file file;
    if (fflush(page->parts) != 0 || fflush(page->same) != 0 || page->failed)
        return complain(stderr, path, "no memory for this page");
    if (!atomic_file_open(path, stderr, &file))
        return false;
    print_page(file.stream, page, folder, settings, counts);
    return atomic_file_finish(&file, stderr);
}
