#include "json_file.h"

#include "atomic_file.h"

#include <math.h>

json_t *json_measured(double number)
{
    return isfinite(number) ? json_real(number) : json_null();
}

bool json_print_line(json_t *of, FILE *out)
{
    bool whole = of != NULL;
    if (whole) {
        json_dumpf(of, out, JSON_MEASURED);
        fputc('\n', out);
    }
    json_decref(of);
    return whole;
}

bool json_write_file(json_t *of, const char *path, FILE *messages)
{
    atomic_file file;
    if (!of) {
        fprintf(messages, "%s: error: no memory\n", path);
        return false;
    }
    bool opened = atomic_file_open(path, messages, &file);
    if (opened) {
        json_dumpf(of, file.stream, JSON_MEASURED | JSON_INDENT(2));
        fputc('\n', file.stream);
    }
    json_decref(of);
    return opened && atomic_file_finish(&file, messages);
}
