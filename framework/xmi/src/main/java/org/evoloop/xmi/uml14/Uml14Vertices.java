package org.evoloop.xmi.uml14;

import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.evoloop.xmi.dialect.ChartScope;
import org.evoloop.xmi.dialect.Problems;

/** Assigns a key to each vertex of a machine, and follows submachine states. */
final class Uml14Vertices {
    private static final Set<String> STATES = Set.of("SimpleState", "State", "CompositeState", "SubmachineState");

    private final Problems problems;

    Uml14Vertices(Problems problems) {
        this.problems = problems;
    }

    static boolean isState(Uml14Element vertex) {
        return STATES.contains(vertex.type());
    }

    static boolean isConcurrent(Uml14Element state) {
        return state.text("isConcurrent").equals("true");
    }

    /** The vertices in a state. */
    static List<Uml14Element> inside(Uml14Element state) {
        return Stream.concat(state.owned("subvertex").stream(), state.owned("substate").stream())
                .toList();
    }

    /** The composite state that contains everything else. */
    static List<Uml14Element> tops(Uml14Element machine) {
        return machine.owned("top");
    }

    /**
     * Whether Enterprise Architect stores the states of a whole package here. The activity model of an activity has no
     * states.
     */
    static boolean isActivityModelOfStates(Uml14Element element) {
        return element.type().equals("ActivityModel")
                && tops(element).stream().flatMap(top -> inside(top).stream()).anyMatch(Uml14Vertices::isState);
    }

    /** Registers all vertices of the scope's machine. */
    void define(ChartScope<Uml14Element> scope) {
        tops(scope.machine()).forEach(top -> content(scope, top, ""));
    }

    private void content(ChartScope<Uml14Element> scope, Uml14Element owner, String outerState) {
        for (Uml14Element vertex : inside(owner)) {
            if (isConcurrent(owner)) {
                // The vertex is a region; its contents belong to the state.
                content(scope, vertex, outerState);
                continue;
            }
            scope.define(vertex, outerState, problems);
            if (isState(vertex)) {
                submachine(scope, vertex);
                content(scope, vertex, scope.key(vertex.id()));
            } else if (vertex.type().equals("StubState")) {
                stub(scope, vertex, owner);
            }
        }
    }

    private void submachine(ChartScope<Uml14Element> scope, Uml14Element state) {
        for (Uml14Element machine : state.all("submachine", problems)) {
            scope.open(state, machine, problems).ifPresent(this::define);
        }
    }

    /** A stub state is an alias for a state of the submachine. */
    private void stub(ChartScope<Uml14Element> scope, Uml14Element stub, Uml14Element state) {
        String path = stub.text("referenceState");
        String name = path.substring(path.lastIndexOf(':') + 1);
        List<String> keys = scope.submachine(state.id()).stream()
                .flatMap(submachine -> named(submachine, tops(submachine.machine()), name).stream())
                .toList();
        if (keys.size() == 1) {
            scope.alias(stub.id(), keys.get(0));
        } else {
            problems.add(
                    stub.line(),
                    "stub state " + stub.label() + " refers to " + Problems.quote(path) + ", which "
                            + (keys.isEmpty() ? "no vertex" : "more than one vertex")
                            + " of the submachine is called; name one");
        }
    }

    private static List<String> named(ChartScope<Uml14Element> scope, List<Uml14Element> owners, String name) {
        return owners.stream()
                .flatMap(owner -> inside(owner).stream())
                .flatMap(vertex -> Stream.concat(
                        vertex.name().equals(name) ? scope.find(vertex.id()).stream() : Stream.of(),
                        named(scope, List.of(vertex), name).stream()))
                .toList();
    }
}
