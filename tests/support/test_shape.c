/* SPDX-License-Identifier: MIT */
#include "test_shape.h"

#include "long_vector.h"
#include "objects.h"

const test_shape *test_shape_of(sure_shape shape)
{
#define ROW(shape, SHAPE) &test_shape_##shape,
    static const test_shape *const rows[SURE_SHAPES] = {SURE_EACH_SHAPE(ROW)};
#undef ROW
    return rows[shape];
}

const char *case_text(const sure_case *c)
{
    static char line[CASE_LINE_MAX];
    case_print(c, line);
    return line;
}

static const double *numbers_of(const sure_object *object)
{
    return (const double *)(const void *)&object->as;
}

bool shape_has(sure_shape shape, sure_kind kind)
{
    const sure_shape_info *info = sure_shape_info_of(shape);
    for (int i = 0; i < info->field_count; i++) {
        if (info->fields[i].kind == kind)
            return true;
    }
    return false;
}

sure_object object_made(sure_shape shape, sure_vec3 place, sure_vec3 normal, sure_vec3 end,
                        double radius)
{
    const sure_shape_info *info = sure_shape_info_of(shape);
    sure_object made = {.shape = shape};
    double *numbers = (double *)(void *)&made.as;
    put_vector(numbers, place);
    for (int i = 1; i < info->field_count; i++) {
        const sure_shape_field *field = &info->fields[i];
        double *x = numbers + field->at;
        if (field->kind == SURE_KIND_RADIUS)
            *x = radius;
        else
            put_vector(x, field->kind == SURE_KIND_NORMAL ? normal : end);
        for (int k = 0; k < 3 && field->kind == SURE_KIND_HIGH; k++) {
            double low = fmin(numbers[k], x[k]);
            x[k] = fmax(numbers[k], x[k]);
            numbers[k] = low;
        }
    }
    return made;
}

sure_object object_through(sure_shape shape, sure_vec3 p, double half, double s, bool cap)
{
    const test_shape *row = test_shape_of(shape);
    sure_vec3 from = row->through[cap].place, to = row->through[cap].end;
    sure_vec3 place = {p.x + (half + s * from.x), p.y + s * from.y, p.z + s * from.z};
    sure_vec3 end = {p.x + (half + s * to.x), p.y + s * to.y, p.z + s * to.z};
    return object_made(shape, place, (sure_vec3){4, -3, 0}, end, s * row->through[cap].radius);
}

sure_vec3 object_place(const sure_object *object)
{
    return vector_of(numbers_of(object));
}

sure_object object_sided(const sure_object *object)
{
    if (!shape_has(object->shape, SURE_KIND_NORMAL))
        return *object;
    const double *numbers = numbers_of(object);
    return (sure_object){SURE_SHAPE_PLANE, {.plane = {vector_of(numbers), vector_of(numbers + 3)}}};
}

long double object_reach(sure_vec3 o, const sure_object *object)
{
    const sure_shape_info *info = sure_shape_info_of(object->shape);
    const double *numbers = numbers_of(object);
    sure_vec3 place = object_place(object);
    long double sum = long_length(long_between(place, o));
    for (int i = 1; i < info->field_count; i++) {
        const sure_shape_field *field = &info->fields[i];
        if (field->kind == SURE_KIND_RADIUS)
            sum += numbers[field->at];
        else if (field->kind != SURE_KIND_NORMAL)
            sum += long_length(long_between(place, vector_of(numbers + field->at)));
    }
    return sum;
}

sure_vec3 vector_sum(double a, sure_vec3 v, double b, sure_vec3 w)
{
    return (sure_vec3){a * v.x + b * w.x, a * v.y + b * w.y, a * v.z + b * w.z};
}
