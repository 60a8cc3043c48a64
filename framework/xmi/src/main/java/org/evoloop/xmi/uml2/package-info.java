/**
 * UML 2 in XMI 2.x, which most tools write, each with habits of its own: Eclipse UML2 and Papyrus, Enterprise
 * Architect, MagicDraw and Cameo, StarUML, Visual Paradigm. The element's type, not the place where a tool puts it,
 * decides what it is.
 *
 * <p>This package may use {@code org.evoloop.xmi.dialect}, {@code org.evoloop.statechart} and
 * {@code org.evoloop.statemachine}.
 */
@NullMarked
package org.evoloop.xmi.uml2;

import org.jspecify.annotations.NullMarked;
