#pragma once
#include "app/buffer_view/buffer_feature.h"

namespace app {

class BufferCompare;
class StageDifferences;
enum class CompareMode : unsigned char;

// The comparison of a view's buffer with another: its menu, its keys, its bar and the list of differences by stage.
class CompareChoice : public BufferFeature {
public:
    explicit CompareChoice(BufferView& view);

    BufferCompare& compare() { return *m_compare; }
    void letGo();  // of the keys that are held: they show something else meanwhile

    bool press(const QKeyEvent& key) override;
    void release(const QKeyEvent& key) override;
    void addTo(ShowRequest& request) override;
    void write(lessons::BufferShown& state) const override;
    pipeline::Errors read(const lessons::BufferShown& state) override;
    bool busy() const override;
    void cancel() override;
    void retry() override;

private:
    void compareBy(CompareMode mode);  // asks for B first if there is none

    BufferCompare* m_compare;
    StageDifferences* m_stages;
};

}  // namespace app
