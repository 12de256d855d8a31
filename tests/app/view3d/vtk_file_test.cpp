// What export writes for VTK, read by VTK.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStructuredPoints.h>

#include "pipeline/export/export_frame.h"
#include "pipeline/scene/mesh/topology.h"
#include "tests/support/files.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

vtkNew<vtkGenericDataObjectReader> readerOf(const std::filesystem::path& file) {
    vtkNew<vtkGenericDataObjectReader> reader;
    reader->SetFileName(file.c_str());
    reader->ReadAllScalarsOn(), reader->ReadAllVectorsOn(), reader->ReadAllNormalsOn();
    reader->Update();
    return reader;
}

void expectSame(vtkDataArray* array, const AnyBuffer& buffer) {
    ASSERT_TRUE(array) << buffer.name.text();
    const auto channels = std::size_t(buffer.channels());
    ASSERT_EQ(std::size_t(array->GetNumberOfTuples()) * channels, buffer.count());
    for (std::size_t i = 0; i < buffer.count(); ++i)
        ASSERT_EQ(array->GetComponent(vtkIdType(i / channels), int(i % channels)), buffer.flat(i));
}

class VtkFile : public testing::Test {
protected:
    VtkFile() {
        ExportRequest request;
        request.folder = folder / "out", request.formats = {"vtk", "polydata"};
        frame = test::frameOf(test::spheres(), ~BufferSet());
        EXPECT_TRUE(exportFrame(*frame, request));
    }
    test::TemporaryFolder folder;
    FramePtr frame;
};

// Row by row from the bottom: VTK's y points up.
TEST_F(VtkFile, HoldsPictures) {
    for (const BufferId id : {BufferId::ZView, BufferId::PolygonId, BufferId::Normal, BufferId::Color}) {
        const AnyBuffer buffer = *frame->buffer({id});
        const auto reader = readerOf(folder / "out" / (buffer.name.text() + ".vtk"));
        auto* points = vtkStructuredPoints::SafeDownCast(reader->GetOutput());
        ASSERT_TRUE(points) << buffer.name.text();
        EXPECT_EQ(points->GetDimensions()[0], int(buffer.columns()));
        EXPECT_EQ(points->GetDimensions()[1], int(buffer.rows()));
        vtkDataArray* const array = points->GetPointData()->GetArray(buffer.name.text().c_str());
        ASSERT_TRUE(array) << buffer.name.text();
        for (std::size_t y = 0; y < buffer.rows(); ++y)
            for (std::size_t x = 0; x < buffer.columns(); ++x)
                for (int c = 0; c < buffer.channels(); ++c)
                    ASSERT_EQ(array->GetComponent(vtkIdType((buffer.rows() - 1 - y) * buffer.columns() + x), c),
                              buffer.value(x, y, c));
    }
}

TEST_F(VtkFile, HoldsPolygonsWithWhatStandsAtThem) {
    std::filesystem::path file;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "out"))
        if (entry.path().string().ends_with(".polydata.vtk")) file = entry.path();
    const auto reader = readerOf(file);
    vtkPolyData* const data = reader->GetPolyDataOutput();
    ASSERT_TRUE(data);
    expectSame(data->GetPoints()->GetData(), *frame->buffer({BufferId::VerticesWorld}));
    const Topology& topology = frame->topology();
    ASSERT_EQ(std::size_t(data->GetNumberOfPolys()), topology.polygonCount());
    vtkDataArray* const objects = data->GetCellData()->GetArray("object");
    ASSERT_TRUE(objects);
    for (std::size_t p = 0; p < topology.polygonCount(); ++p) {
        const Topology::Corners corners = topology.corners(p);
        vtkNew<vtkIdList> of;
        data->GetCellPoints(vtkIdType(p), of);
        ASSERT_EQ(std::size_t(of->GetNumberOfIds()), corners.size());
        for (std::size_t i = 0; i < corners.size(); ++i) ASSERT_EQ(of->GetId(vtkIdType(i)), vtkIdType(corners[i]));
        ASSERT_EQ(objects->GetComponent(vtkIdType(p), 0), topology.objectOfPolygon(p));
    }
    expectSame(data->GetPointData()->GetNormals(), *frame->buffer({BufferId::VerticesNormal}));
    expectSame(data->GetPointData()->GetArray("vertices.screen"), *frame->buffer({BufferId::VerticesScreen}));
    expectSame(data->GetCellData()->GetArray("polygons.normal"), *frame->buffer({BufferId::PolygonsNormal}));
    expectSame(data->GetCellData()->GetArray("polygons.verdict"), *frame->buffer({BufferId::PolygonsVerdict}));
}

}  // namespace
}  // namespace pipeline
