#include "key.h"

#include <string.h>

#define TALL KEY_HEIGHT
#define WIDE KEY_ADVANCE

/* clang-format off */
static const char letters[] = "0123456789.-_abcdefilmnoprstux";

/* Ten letters a band, a blank column behind each; the last row is for what hangs down. */
#define BAND 10
static const char *const art[][TALL] = {
    {
        " ###    #    ###   ###     #  #####  ###  #####  ###   ###  ",
        "#   #  ##   #   # #   #   ##  #     #         # #   # #   # ",
        "#  ##   #       #     #  # #  ####  #        #  #   # #   # ",
        "# # #   #      #    ##  #  #      # ####     #   ###   #### ",
        "##  #   #     #       # #####     # #   #   #   #   #     # ",
        "#   #   #    #    #   #    #  #   # #   #   #   #   #     # ",
        " ###   ###  #####  ###     #   ###   ###    #    ###   ###  ",
        "                                                            ",
    },
    {
        "                        #               #         ##    #   ",
        "                        #               #        #          ",
        "                   ###  ####   ####  ####  ###  ####   ##   ",
        "      #####           # #   # #     #   # #   #  #      #   ",
        "                   #### #   # #     #   # #####  #      #   ",
        " ##               #   # #   # #     #   # #      #      #   ",
        " ##                #### ####   ####  ####  ###   #     ###  ",
        "            #####                                           ",
    },
    {
        " ##                                        #                ",
        "  #                                        #                ",
        "  #   ## #  ####   ###  ####  # ##   #### ####  #   # #   # ",
        "  #   # # # #   # #   # #   # ##    #      #    #   #  # #  ",
        "  #   # # # #   # #   # #   # #      ###   #    #   #   #   ",
        "  #   # # # #   # #   # ####  #         #  #    #   #  # #  ",
        " ###  # # # #   #  ###  #     #     ####    ##   #### #   # ",
        "                        #                                   ",
    },
};
/* clang-format on */

void key_fill(picture *image, int x, int y, int width, int height, key_color color)
{
    for (int row = y > 0 ? y : 0; row < y + height && row < image->height; row++) {
        for (int column = x > 0 ? x : 0; column < x + width && column < image->width; column++) {
            uint8_t *at = image->rgb + 3 * ((size_t)row * (size_t)image->width + (size_t)column);
            at[0] = color.r;
            at[1] = color.g;
            at[2] = color.b;
        }
    }
}

static void draw_letter(picture *image, int x, int y, int scale, key_color color, char letter)
{
    const char *found = strchr(letters, letter);
    if (!found || letter == '\0')
        return;
    int index = (int)(found - letters);
    for (int row = 0; row < TALL; row++) {
        const char *dots = art[index / BAND][row] + WIDE * (index % BAND);
        for (int column = 0; column < WIDE; column++) {
            if (dots[column] == '#')
                key_fill(image, x + scale * column, y + scale * row, scale, scale, color);
        }
    }
}

void key_text(picture *image, int x, int y, int scale, key_color color, const char *text)
{
    for (; *text != '\0'; text++, x += WIDE * scale)
        draw_letter(image, x, y, scale, color, *text);
}

int key_width(const char *text, int scale)
{
    return WIDE * scale * (int)strlen(text);
}
