// Another program's reader opens the OBJ of a textured model.
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <QTemporaryDir>
#include <QtTest>

#include "cloud/obj.h"
#include "files/files.h"
#include "tests/ui/program.h"

class ObjInVtkTest : public QObject {
  Q_OBJECT

 private slots:
  void itsPlacesInThePictureAreVtks();
};

void ObjInVtkTest::itsPlacesInThePictureAreVtks() {
  const QTemporaryDir folder;
  ostraka::TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {40, 0, 0}, {0, 30, 0}, {0, 0, 20}};
  mesh.normals = {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  const std::vector<Eigen::Vector2f> uv = {{0, 0}, {1, 0}, {0, 1}, {0.25f, 0.75f}};
  const std::string file = folder.filePath("model.obj").toStdString();
  const auto text = ostraka::formatObj(mesh, uv, "model.mtl");
  QVERIFY(text.has_value());
  QVERIFY(ostraka::writeFileAtomically(file, *text).has_value());
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* read = reader->GetOutput();
  QCOMPARE(read->GetNumberOfPoints(), vtkIdType{4});
  QCOMPARE(read->GetNumberOfPolys(), vtkIdType{4});
  vtkDataArray* places = read->GetPointData()->GetTCoords();
  QVERIFY(places != nullptr);
  QVERIFY(read->GetPointData()->GetNormals() != nullptr);
  for (vtkIdType i = 0; i < 4; ++i) {
    const Eigen::Vector2f& place = uv[static_cast<std::size_t>(i)];
    QCOMPARE(places->GetComponent(i, 0), double{place.x()});
    QCOMPARE(places->GetComponent(i, 1), 1 - double{place.y()});
    double point[3];
    read->GetPoint(i, point);
    for (int axis = 0; axis < 3; ++axis)
      QCOMPARE(point[axis], double{mesh.vertices[static_cast<std::size_t>(i)][axis]});
  }
}

OSTRAKA_UI_TEST(ObjInVtkTest)
#include "obj_in_vtk_test.moc"
