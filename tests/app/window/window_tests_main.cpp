#include "app/desktop/window_main.h"
#include "tests/app/shared_process.h"

int main(int argc, char** argv) {
    app::prepareApplication();
    return test::runAppTests(argc, argv);
}
