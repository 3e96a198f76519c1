#include "shape_suite.h"

int main(void)
{
    return shape_suite_run(suite_create("plane"), SURE_SHAPE_PLANE);
}
