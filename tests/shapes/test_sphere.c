#include "shape_suite.h"

int main(void)
{
    return shape_suite_run(suite_create("sphere"), SURE_SHAPE_SPHERE);
}
