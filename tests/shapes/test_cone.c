#include "shape_suite.h"

int main(void)
{
    return shape_suite_run(suite_create("cone"), SURE_SHAPE_CONE);
}
