#include "shape_suite.h"

int main(void)
{
    return shape_suite_run(suite_create("cylinder"), SURE_SHAPE_CYLINDER);
}
