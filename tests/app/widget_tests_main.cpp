#include "tests/app/shared_process.h"

int main(int argc, char** argv) { return test::runAppTests(argc, argv); }
