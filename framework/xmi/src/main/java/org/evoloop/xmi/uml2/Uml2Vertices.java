package org.evoloop.xmi.uml2;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.evoloop.xmi.dialect.ChartScope;
import org.evoloop.xmi.dialect.Problems;

/** Assigns a key to each vertex of a machine, and follows submachine states. */
final class Uml2Vertices {
    private static final Set<String> POINTS = Set.of("entryPoint", "exitPoint");

    private final Uml2References references;
    private final Problems problems;

    Uml2Vertices(Uml2References references, Problems problems) {
        this.references = references;
        this.problems = problems;
    }

    /** Whether this is an entry or exit point, which belongs to its state or machine wherever a tool puts it. */
    static boolean isPoint(Uml2Element vertex) {
        return vertex.type().equals("Pseudostate") && POINTS.contains(vertex.attribute("kind"));
    }

    /** The vertex's type; Visual Paradigm writes a final state as a pseudostate of that kind. */
    static String type(Uml2Element vertex) {
        boolean end =
                vertex.type().equals("Pseudostate") && vertex.attribute("kind").equals("final");
        return end ? "FinalState" : vertex.type();
    }

    /** The entry and exit points of a state or machine. */
    static List<Uml2Element> points(Uml2Element owner) {
        List<Uml2Element> points = new ArrayList<>(owner.owned("connectionPoint"));
        owner.owned("region")
                .forEach(region -> region.owned("subvertex").stream()
                        .filter(Uml2Vertices::isPoint)
                        .forEach(points::add));
        return points;
    }

    /** Registers all vertices of the scope's machine. */
    void define(ChartScope<Uml2Element> scope) {
        content(scope, scope.machine(), "");
    }

    private void content(ChartScope<Uml2Element> scope, Uml2Element owner, String outerState) {
        owner.owned("connectionPoint").forEach(point -> scope.define(point, outerState, problems));
        for (Uml2Element region : owner.owned("region")) {
            for (Uml2Element vertex : region.owned("subvertex")) {
                scope.define(vertex, outerState, problems);
                if (vertex.type().equals("State")) {
                    content(scope, vertex, scope.key(vertex.id()));
                    submachine(scope, vertex);
                }
            }
        }
    }

    private void submachine(ChartScope<Uml2Element> scope, Uml2Element state) {
        references
                .one(state, "submachine")
                .flatMap(machine -> scope.open(state, machine, problems))
                .ifPresent(this::define);
        state.owned("connection").forEach(connection -> connection(scope, state, connection));
    }

    /** A connection point reference is an alias for a point of the submachine. */
    private void connection(ChartScope<Uml2Element> scope, Uml2Element state, Uml2Element connection) {
        Uml2Vocabulary.check(connection, problems);
        List<Uml2Element> points = new ArrayList<>(references.all(connection, "entry"));
        points.addAll(references.all(connection, "exit"));
        Optional<String> key = points.size() == 1
                ? scope.submachine(state.id())
                        .flatMap(submachine -> submachine.find(points.get(0).id()))
                : Optional.empty();
        if (key.isPresent()) {
            scope.alias(connection.id(), key.get());
        } else {
            problems.add(
                    connection.place(),
                    "connection point reference " + connection.label() + " of state " + state.label()
                            + " does not refer to one entry or exit point of the state's submachine; "
                            + "choose one in the submachine");
        }
    }
}
