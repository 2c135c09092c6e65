# The VTK module Isthmus::vtkIsthmus: every class and algorithm of the library, room by room.

set(classes
  Filters/Curvature/vtkBindingSites
  Filters/Curvature/vtkHessianCurvature
  Filters/Curvature/vtkPolarizedCurvature
  Filters/Curvature/vtkScalarRegions
  Filters/Curvature/vtkSurfaceCurvature
  Filters/Imaging/vtkDiffusionAlgorithm
  Filters/Imaging/vtkDiffusionHighPass
  Filters/Imaging/vtkHighOrderDiffusion
  Filters/Imaging/vtkPDETransform
  Filters/Meshing/vtkDelaunayIsosurface
  Filters/Meshing/vtkMeshQualityReport
  Filters/Meshing/vtkSurfaceMeasures
  Filters/Meshing/vtkSurfaceRemesh
  Filters/Meshing/vtkSurfaceToGrid
  Filters/Meshing/vtkTetrahedralMesher
  Filters/Molecular/vtkMolecularDensity
  Filters/Topology/vtkCellIncidence
  Filters/Topology/vtkChokingLoops
  Filters/Topology/vtkLoopShortening
  Filters/Topology/vtkOffsetSurface
  Filters/Topology/vtkTetCutaway
  Readers/vtkCombinatorialMeshReader
  Readers/vtkCombinatorialMeshWriter
  Readers/vtkMacromoleculeReader
  Readers/vtkMRCMapReader
  Readers/vtkMSMSReader
  Readers/vtkOpenDXReader
  Readers/vtkOpenDXWriter)

# The only sources that include CGAL, which needs -frounding-math and is slow to compile.
set(cgal_sources
  Filters/Meshing/CGALTetrahedra.cxx
  Filters/Meshing/DelaunayIsosurface.cxx
  Filters/Meshing/SurfaceRemesh.cxx
  Filters/Meshing/SurfaceRepair.cxx
  Filters/Topology/DelaunayFiltration.cxx)

set(sources
  ${cgal_sources}
  Filters/Curvature/BindingSites.cxx
  Filters/Curvature/CurvatureDescriptors.cxx
  Filters/Curvature/CurvatureOfImage.cxx
  Filters/Curvature/EdgeBends.cxx
  Filters/Curvature/FiniteDifference.cxx
  Filters/Curvature/GaussianScale.cxx
  Filters/Curvature/HessianCurvature.cxx
  Filters/Curvature/HullDepth.cxx
  Filters/Curvature/PointDerivative.cxx
  Filters/Curvature/PolarizedCurvature.cxx
  Filters/Curvature/RegionTables.cxx
  Filters/Curvature/ScalarRegions.cxx
  Filters/Curvature/ShapeRows.cxx
  Filters/Curvature/StarCurvature.cxx
  Filters/Curvature/SurfaceCurvature.cxx
  Filters/Curvature/SurfacePatch.cxx
  Filters/Imaging/AutomaticDenoising.cxx
  Filters/Imaging/BoxMean.cxx
  Filters/Imaging/DiffusionHighPass.cxx
  Filters/Imaging/DiffusionImage.cxx
  Filters/Imaging/DiffusionOperator.cxx
  Filters/Imaging/DiffusionPipeline.cxx
  Filters/Imaging/DiffusionRows.cxx
  Filters/Imaging/EdgeCoefficient.cxx
  Filters/Imaging/HighOrderDiffusion.cxx
  Filters/Imaging/NoiseEstimate.cxx
  Filters/Imaging/PDETransform.cxx
  Filters/Imaging/RankParts.cxx
  Filters/Imaging/ResidualReturn.cxx
  Filters/Imaging/TimeSteps.cxx
  Filters/Meshing/CartesianMeasures.cxx
  Filters/Meshing/ChildProcess.cxx
  Filters/Meshing/ClosedLevelSet.cxx
  Filters/Meshing/GridDistance.cxx
  Filters/Meshing/GridImages.cxx
  Filters/Meshing/LevelCrossings.cxx
  Filters/Meshing/MeshQuality.cxx
  Filters/Meshing/PolyDataMesh.cxx
  Filters/Meshing/ShellNesting.cxx
  Filters/Meshing/SurfaceCheck.cxx
  Filters/Meshing/SurfaceCrossings.cxx
  Filters/Meshing/SurfaceMeasures.cxx
  Filters/Meshing/SurfaceSeeds.cxx
  Filters/Meshing/SurfaceTopology.cxx
  Filters/Meshing/TetGenFiles.cxx
  Filters/Meshing/TetGenProcess.cxx
  Filters/Meshing/TetrahedralMesher.cxx
  Filters/Meshing/TriangleTree.cxx
  Filters/Molecular/BallBricks.cxx
  Filters/Molecular/MolecularDensity.cxx
  Filters/Support/CellType.cxx
  Filters/Support/ChosenScalars.cxx
  Filters/Support/GridCells.cxx
  Filters/Support/ImageExtent.cxx
  Filters/Support/ParallelFor.cxx
  Filters/Support/PolyDataTriangles.cxx
  Filters/Support/TriangleStars.cxx
  Filters/Topology/CellEdgeTable.cxx
  Filters/Topology/CellFiltration.cxx
  Filters/Topology/ChokingLoops.cxx
  Filters/Topology/ChokingLoopsOutput.cxx
  Filters/Topology/ChokingSurface.cxx
  Filters/Topology/CompactCombinatorialMap.cxx
  Filters/Topology/ConformingGenerators.cxx
  Filters/Topology/CutAndMerge.cxx
  Filters/Topology/EdgeStrip.cxx
  Filters/Topology/EdgeTable.cxx
  Filters/Topology/EnclosureTest.cxx
  Filters/Topology/FaceTable.cxx
  Filters/Topology/FeatureMembrane.cxx
  Filters/Topology/FiltrationPairs.cxx
  Filters/Topology/GeneratorCompletion.cxx
  Filters/Topology/HalfFaceMatching.cxx
  Filters/Topology/LoopFeature.cxx
  Filters/Topology/LoopShortening.cxx
  Filters/Topology/LowerStarFiltration.cxx
  Filters/Topology/OffsetSurface.cxx
  Filters/Topology/ShapeFeatures.cxx
  Filters/Topology/SpaceRegions.cxx
  Filters/Topology/StarTable.cxx
  Filters/Topology/StripFunnel.cxx
  Filters/Topology/SurfaceAdjacency.cxx
  Filters/Topology/SurfaceDistance.cxx
  Filters/Topology/SurfaceGenerators.cxx
  Filters/Topology/SurfaceHomology.cxx
  Filters/Topology/SurfaceInComplex.cxx
  Filters/Topology/SurfaceSampling.cxx
  Filters/Topology/TetCutaway.cxx
  Readers/AtomSelection.cxx
  Readers/ByteSource.cxx
  Readers/ChemicalElement.cxx
  Readers/CombinatorialMeshParser.cxx
  Readers/CombinatorialMeshWriter.cxx
  Readers/CompressedSource.cxx
  Readers/CovalentBonds.cxx
  Readers/GemmiStructure.cxx
  Readers/MacromoleculeReader.cxx
  Readers/MoleculeOutput.cxx
  Readers/MRCFieldData.cxx
  Readers/MRCGeometry.cxx
  Readers/MRCHeader.cxx
  Readers/MRCHeaderWords.cxx
  Readers/MRCMap.cxx
  Readers/MRCMode.cxx
  Readers/MRCVoxels.cxx
  Readers/MSMSReader.cxx
  Readers/OpenDXReader.cxx
  Readers/OpenDXText.cxx
  Readers/OpenDXWriter.cxx
  Readers/PDBStream.cxx
  Readers/PlainFile.cxx
  Readers/PQRFile.cxx
  Readers/SkewedLattice.cxx
  Readers/StridedCopy.cxx
  Readers/XYZFile.cxx)

# Loops with square roots and comparisons vectorise only without errno and signals for them; values
# (infinities and NaN too) are the same.
if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set_source_files_properties(
    Filters/Curvature/FiniteDifference.cxx
    Filters/Curvature/ShapeRows.cxx
    Filters/Imaging/DiffusionRows.cxx
    PROPERTIES COMPILE_OPTIONS "-fno-math-errno;-fno-trapping-math")
endif ()

vtk_module_add_module(Isthmus::vtkIsthmus
  CLASSES ${classes}
  SOURCES ${sources})

# Public, since the wrappers include every class by its bare name; installed headers lie flat.
foreach (room IN ITEMS Filters/Curvature Filters/Imaging Filters/Meshing
  Filters/Molecular Filters/Support Filters/Topology Readers)
  vtk_module_include(Isthmus::vtkIsthmus
    PUBLIC "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/${room}>")
endforeach ()
vtk_module_compile_features(Isthmus::vtkIsthmus PUBLIC cxx_std_17)

# VTK's own build (remote module) has no target of ours for warnings and sanitizers.
if (TARGET isthmus_compiler)
  vtk_module_link(Isthmus::vtkIsthmus PRIVATE "$<BUILD_INTERFACE:isthmus_compiler>")
endif ()

find_package(BZip2 REQUIRED)
vtk_module_link(Isthmus::vtkIsthmus PRIVATE BZip2::BZip2)

# Headers only; Debian's gemmi-dev has no CMake package. Its CIF grammar is built on PEGTL.
find_path(GEMMI_INCLUDE_DIR gemmi/pdb.hpp REQUIRED)
find_path(PEGTL_INCLUDE_DIR tao/pegtl.hpp REQUIRED)
vtk_module_include(Isthmus::vtkIsthmus SYSTEM PRIVATE
  "${GEMMI_INCLUDE_DIR}" "${PEGTL_INCLUDE_DIR}")
if (ISTHMUS_SANITIZE)
  # gemmi shifts negative characters and lets over-long numbers wrap, on purpose or not: harmless
  # with every compiler we know, and what it makes of them is checked.
  set_source_files_properties(Readers/GemmiStructure.cxx PROPERTIES
    COMPILE_OPTIONS "-fno-sanitize=shift,signed-integer-overflow")
endif ()

find_package(Eigen3 REQUIRED NO_MODULE)
vtk_module_link(Isthmus::vtkIsthmus PRIVATE "$<BUILD_INTERFACE:Eigen3::Eigen>")

# Not linked as CGAL::CGAL, whose compile options would slow down everybody else's loops.
find_package(CGAL 5.5 REQUIRED)
vtk_module_include(Isthmus::vtkIsthmus SYSTEM PRIVATE ${CGAL_INCLUDE_DIRS})
vtk_module_link(Isthmus::vtkIsthmus PRIVATE ${MPFR_LIBRARIES} ${GMP_LIBRARIES})
set_source_files_properties(${cgal_sources} PROPERTIES
  COMPILE_OPTIONS "-frounding-math"
  COMPILE_DEFINITIONS CGAL_NO_WARNINGS) # they go to stderr; ours go to VTK
