/* SPDX-License-Identifier: MIT */
#include "manual.h"

#include <string.h>

typedef enum { VALUE_NONE, VALUE_WORDS, VALUE_FILE, VALUE_OTHER } value_kind;

/* "a, b or c" as "a b c"; false where it is no list of words. */
static bool read_list(const char *list, char *words, size_t size)
{
    size_t length = 0;
    while (*list != '\0') {
        size_t piece = strcspn(list, ", ");
        length += (size_t)snprintf(words + length, size - length, "%s%.*s", length > 0 ? " " : "",
                                   (int)piece, list);
        if (length >= size)
            return false;
        list += piece;
        size_t between = strncmp(list, ", ", 2) == 0 ? 2 : strncmp(list, " or ", 4) == 0 ? 4 : 0;
        if (*list != '\0' && between == 0)
            return false;
        list += between;
    }
    return length > 0;
}

/* An option's reader tells the words that it expects when it is handed something that is none; what
 * any text would do for is a file, by its name, or can't be completed. */
static value_kind kind_of(const cli_option *row, char *words, size_t size)
{
    static const char *const files[] = {"FILE", "FOLDER", "DIR2"};
    for (size_t i = 0; row->value && i < sizeof files / sizeof *files; i++) {
        if (strcmp(row->value, files[i]) == 0)
            return VALUE_FILE;
    }
    const char *expected = row->value ? row->read(row, "?") : NULL;
    return !row->value                                    ? VALUE_NONE
           : expected && read_list(expected, words, size) ? VALUE_WORDS
                                                          : VALUE_OTHER;
}

/* Text within single quotes: `special` are the characters that need `escape` in front, and a quote
 * is written as the shell has it. */
static void put_quoted(FILE *out, const char *text, const char *special, const char *quote)
{
    for (; *text != '\0'; text++) {
        if (*text == '\'') {
            fputs(quote, out);
            continue;
        }
        if (strchr(special, *text))
            fputc('\\', out);
        fputc(*text, out);
    }
}

/* The rows of a table, its headings left out; then --help. */
static const cli_option *next_row(const cli_option *row)
{
    if (row == &cli_help)
        return NULL;
    while (!row->name && row->help)
        row++;
    return row->name ? row : &cli_help;
}
#define EACH_ROW(row, command)                                                                     \
    const cli_option *row = next_row((command)->options);                                          \
    row;                                                                                           \
    row = row == &cli_help ? NULL : next_row(row + 1)

/* bash: a case for each option that has a value, and one for what else a command takes. */

static void bash_command(FILE *out, const cli_command *command)
{
    char words[1024];
    for (EACH_ROW(row, command)) {
        value_kind kind = kind_of(row, words, sizeof words);
        if (kind == VALUE_NONE)
            continue;
        fprintf(out, "    %s,%s%s) ", cli_word_of(command), cli_dashes(row), row->name);
        if (kind == VALUE_WORDS)
            fprintf(out, "words='%s' ", words);
        fputs(kind == VALUE_FILE ? "files=yes ;;\n" : ";;\n", out);
    }
    fprintf(out, "    %s,*) options='", cli_word_of(command));
    for (EACH_ROW(row, command))
        fprintf(out, "%s%s ", cli_dashes(row), row->name);
    fputs("' files=yes ;;\n", out);
}

void manual_bash(FILE *out)
{
    fputs("# Completes the words of surehit. Bash takes the = of --tier=exact for a word.\n"
          "_surehit() {\n"
          "    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}\n"
          "    local command=${COMP_WORDS[1]} words='' options='' files=''\n"
          "    if [[ $current == = ]]; then\n"
          "        current=''\n"
          "    elif [[ $before == = ]]; then\n"
          "        before=${COMP_WORDS[COMP_CWORD - 2]}\n"
          "    fi\n"
          "    ((COMP_CWORD > 1)) || command='' before=''\n"
          "    case $command,$before in\n"
          "    ,) words='",
          out);
    for (int i = 0; cli_commands[i]; i++)
        fprintf(out, "%s ", cli_word_of(cli_commands[i]));
    fputs("--help --version' ;;\n", out);
    for (int i = 0; cli_commands[i]; i++)
        bash_command(out, cli_commands[i]);
    fputs("    esac\n"
          "    if [[ $current == -* && $options ]]; then\n"
          "        words=$options files=''\n"
          "    fi\n"
          "    mapfile -t COMPREPLY < <(\n"
          "        [[ $words ]] && compgen -W \"$words\" -- \"$current\"\n"
          "        [[ $files ]] && compgen -f -- \"$current\")\n"
          "    [[ ! $files ]] || compopt -o filenames\n"
          "}\n"
          "complete -F _surehit surehit\n",
          out);
}

/* zsh: an array of what _arguments takes, a command. */

#define ZSH_QUOTE "'\\''"

static void zsh_option(FILE *out, const cli_option *row)
{
    char words[1024];
    value_kind kind = kind_of(row, words, sizeof words);
    bool is_short = row->name[1] == '\0';
    fprintf(out, "        '*%s%s%s[", cli_dashes(row), row->name,
            kind == VALUE_NONE ? ""
            : is_short         ? "+"
                               : "=");
    put_quoted(out, cli_help_of(row), "[]\\", ZSH_QUOTE);
    fputc(']', out);
    if (kind != VALUE_NONE)
        fprintf(out, ":%s:", row->value);
    if (kind == VALUE_WORDS)
        fprintf(out, "(%s)", words);
    fputs(kind == VALUE_FILE ? "_files'\n" : kind == VALUE_OTHER ? " '\n" : "'\n", out);
}

void manual_zsh(FILE *out)
{
    fputs("#compdef surehit\n"
          "# Completes the words of surehit.\n"
          "local -a commands options\n"
          "commands=(\n",
          out);
    for (int i = 0; cli_commands[i]; i++) {
        fprintf(out, "    '%s:", cli_word_of(cli_commands[i]));
        put_quoted(out, cli_commands[i]->summary, ":\\", ZSH_QUOTE);
        fputs("'\n", out);
    }
    fputs(")\n"
          "if ((CURRENT == 2)); then\n"
          "    _describe command commands\n"
          "    return\n"
          "fi\n"
          "case $words[2] in\n",
          out);
    for (int i = 0; cli_commands[i]; i++) {
        fprintf(out, "%s)\n    options=(\n", cli_word_of(cli_commands[i]));
        for (EACH_ROW(row, cli_commands[i]))
            zsh_option(out, row);
        fputs("    )\n    ;;\n", out);
    }
    fputs("esac\n"
          "shift words\n"
          "((CURRENT--))\n"
          "_arguments $options '*:file:_files'\n",
          out);
}

/* fish: a line an option. */

#define FISH_QUOTE "\\'"

static void fish_option(FILE *out, const cli_command *command, const cli_option *row)
{
    char words[1024];
    value_kind kind = kind_of(row, words, sizeof words);
    fprintf(out, "complete -c surehit -n '__fish_seen_subcommand_from %s' -%c %s -d '",
            cli_word_of(command), row->name[1] == '\0' ? 's' : 'l', row->name);
    put_quoted(out, cli_help_of(row), "\\", FISH_QUOTE);
    fputc('\'', out);
    if (kind == VALUE_WORDS)
        fprintf(out, " -x -a '%s'", words);
    fputs(kind == VALUE_FILE ? " -r -F\n" : kind == VALUE_OTHER ? " -x\n" : "\n", out);
}

void manual_fish(FILE *out)
{
    fputs("# Completes the words of surehit.\n", out);
    for (int i = 0; cli_commands[i]; i++) {
        fprintf(out, "complete -c surehit -n __fish_use_subcommand -f -a %s -d '",
                cli_word_of(cli_commands[i]));
        put_quoted(out, cli_commands[i]->summary, "\\", FISH_QUOTE);
        fputs("'\n", out);
        for (EACH_ROW(row, cli_commands[i]))
            fish_option(out, cli_commands[i], row);
    }
}
