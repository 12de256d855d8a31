#include "app/view3d/vtk_turn.h"

namespace app {

std::mutex& vtkTurn() {
    static std::mutex turn;
    return turn;
}

}  // namespace app
