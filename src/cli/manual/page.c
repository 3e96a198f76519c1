/* SPDX-License-Identifier: MIT */
#include "manual.h"

#include <surehit/version.h>

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* Characters as they are typed: roff would make another dash, other quotes, of some. */
static void put(FILE *out, const char *text, size_t length)
{
    for (size_t i = 0; i < length; i++) {
        const char *as = text[i] == '-'    ? "\\-"
                         : text[i] == '\\' ? "\\e"
                         : text[i] == '\'' ? "\\(aq"
                         : text[i] == '`'  ? "\\(ga"
                         : text[i] == '^'  ? "\\(ha"
                         : text[i] == '~'  ? "\\(ti"
                                           : NULL;
        if (as)
            fputs(as, out);
        else
            fputc(text[i], out);
    }
}

static void put_line(FILE *out, const char *text, size_t length)
{
    if (length > 0 && text[0] == '.')
        fputs("\\&", out); /* or it were a request */
    put(out, text, length);
    fputc('\n', out);
}

/* Text in lines, which are filled where they begin in the first column and stay as they are where
 * they do not. A paragraph ends with an empty line. */
static void put_text(FILE *out, const char *text)
{
    bool kept = false, begins = false;
    while (*text != '\0') {
        size_t length = strcspn(text, "\n");
        bool keep = *text == ' ';
        if (keep != kept && length > 0)
            fputs(keep ? ".PP\n.nf\n" : ".fi\n", out);
        if (begins && length > 0 && !keep)
            fputs(".PP\n", out);
        if (length > 0) {
            put_line(out, text, length);
            kept = keep;
        }
        begins = length == 0;
        text += length + (text[length] == '\n');
    }
    if (kept)
        fputs(".fi\n", out);
}

/* surehit-render of "surehit render". */
static void put_page_name(FILE *out, const char *name, bool upper)
{
    for (; *name != '\0'; name++) {
        if (*name == ' ')
            fputs("\\-", out);
        else
            fputc(upper ? toupper((unsigned char)*name) : *name, out);
    }
}

static void put_option(FILE *out, const cli_option *row)
{
    fputs(row == &cli_help ? ".TP\n\\fB\\-h\\fR, \\fB" : ".TP\n\\fB", out);
    put(out, cli_dashes(row), strlen(cli_dashes(row)));
    put(out, row->name, strlen(row->name));
    fputs("\\fR", out);
    if (row->value) {
        fputs(row->name[1] == '\0' ? " \\fI" : "=\\fI", out);
        put(out, row->value, strlen(row->value));
        fputs("\\fR", out);
    }
    fputc('\n', out);
    const char *help = cli_help_of(row);
    put_line(out, help, strlen(help));
}

static void put_options(FILE *out, const cli_option *row)
{
    fputs(".SH OPTIONS\n", out);
    for (; row->name || row->help; row++) {
        if (row->name)
            put_option(out, row);
        else
            fprintf(out, ".SS \"%s\"\n", row->help);
    }
    put_option(out, &cli_help);
}

/* What print_more prints: paragraphs, each with a line in front. */
static void put_more(FILE *out, void (*print_more)(FILE *out))
{
    char *text = NULL;
    size_t length = 0;
    FILE *memory = open_memstream(&text, &length);
    if (!memory)
        abort();
    print_more(memory);
    if (fclose(memory) != 0)
        abort();
    fputs(".SH NAMES\n", out);
    put_text(out, text + strspn(text, "\n"));
    free(text);
}

static void put_others(FILE *out, const cli_command *command)
{
    fputs(".SH SEE ALSO\n", out);
    if (command != &cli_program)
        fputs(".BR surehit (1)\n", out);
    for (int i = 0; command == &cli_program && cli_commands[i]; i++) {
        fputs(".BR ", out);
        put_page_name(out, cli_commands[i]->name, false);
        fprintf(out, " (1)%s\n", cli_commands[i + 1] ? "," : "");
    }
}

void manual_page(const cli_command *command, FILE *out)
{
    fputs(".TH ", out);
    put_page_name(out, command->name, true);
    fputs(" 1 \"\" \"surehit " SUREHIT_VERSION_TEXT "\" surehit\n.SH NAME\n", out);
    put_page_name(out, command->name, false);
    fprintf(out, " \\- %s\n.SH SYNOPSIS\n.B %s\n", command->summary, command->name);
    put_line(out, command->usage, strlen(command->usage));
    fputs(".SH DESCRIPTION\n", out);
    put_text(out, command->about);
    put_options(out, command->options);
    if (command->print_more)
        put_more(out, command->print_more);
    if (command->statuses) {
        fputs(".SH EXIT STATUS\n", out);
        put_text(out, command->statuses);
    }
    put_others(out, command);
}
