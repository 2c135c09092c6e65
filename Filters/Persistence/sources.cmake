isthmus_room(
  SOURCES
    CellFiltration
    FiltrationPairs
    LowerStarFiltration
  CGAL
    DelaunayFiltration
    RegularFiltration)
