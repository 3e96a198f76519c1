/* The subcommands. `words` are those after the subcommand's name; returned is the exit status. */
#ifndef CLI_COMMANDS_H
#define CLI_COMMANDS_H

int command_render(int count, char **words);
int command_merge(int count, char **words);
int command_check(int count, char **words);
int command_diff(int count, char **words);
int command_regress(int count, char **words);
int command_bench(int count, char **words);
int command_cases(int count, char **words);
int command_answer(int count, char **words);
int command_judge(int count, char **words);
int command_report(int count, char **words);
int command_shrink(int count, char **words);
int command_vectors(int count, char **words);

#endif
