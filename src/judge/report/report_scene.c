/* Pictures, written into the page itself. */
#include "report_parts.h"

/* Base64 (RFC 4648). */
static void print_bytes(FILE *out, const unsigned char *bytes, size_t size)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < size; i += 3) {
        size_t left = size - i;
        unsigned long word = (unsigned long)bytes[i] << 16;
        if (left > 1)
            word |= (unsigned long)bytes[i + 1] << 8;
        if (left > 2)
            word |= bytes[i + 2];
        fputc(digits[word >> 18], out);
        fputc(digits[word >> 12 & 63], out);
        fputc(left > 1 ? digits[word >> 6 & 63] : '=', out);
        fputc(left > 2 ? digits[word & 63] : '=', out);
    }
}

static void print_image(FILE *out, const report_picture *of, const report_png *png,
                        const char *what)
{
    if (!png->bytes)
        return;
    fprintf(out, "<img width=%d height=%d alt='%s, %s' src='data:image/png;base64,", of->width,
            of->height, of->name, what);
    print_bytes(out, png->bytes, png->size);
    fputs("'>", out);
}

static void print_picture(FILE *out, const report_picture *of)
{
    fprintf(out, "<figure><figcaption><b>%s</b> %s</figcaption>", of->name, of->note);
    print_image(out, of, &of->drawn, "the picture");
    print_image(out, of, &of->apart, "where it differs from exact");
    fputs("</figure>\n", out);
}

void report_print_scene(FILE *out, const report_scene *scene)
{
    fputs("<section><h3>", out);
    report_text(out, scene->title);
    fprintf(out, "</h3>\n<p>%s</p>\n<div class=pictures>\n", scene->text);
    for (int i = 0; i < scene->count; i++)
        print_picture(out, &scene->pictures[i]);
    fputs("</div>\n<details><summary>This scene as a file</summary><pre>", out);
    report_text(out, scene->file);
    fputs("</pre></details></section>\n", out);
}
