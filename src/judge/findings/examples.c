/* SPDX-License-Identifier: MIT */
#include "examples.h"

const char *worst_name(int kind)
{
    return kind == WORST_T        ? "largest error of t"
           : kind == WORST_NORMAL ? "largest error of the normal"
                                  : fault_name(kind);
}

example_lines example_lines_of(const example *one)
{
    example_lines lines;
    reply right = reply_of(&one->truth, one->given.to);
    right.has_normal = !one->question.wall;
    case_print(&one->question, lines.question);
    reply_print(&one->given, lines.given);
    reply_print(&right, lines.right);
    return lines;
}

const char *worst_event(const worst_case *one)
{
    const example *of = &one->found;
    return one->kind < FAULTS_WITH_MARGIN
               ? event_name(event_of(&of->question, &of->truth, (fault)one->kind, &of->given))
               : NULL;
}
