package org.evoloop.xmi.uml14;

import org.evoloop.statechart.Statechart;
import org.evoloop.xmi.dialect.DrawnMachine;
import org.evoloop.xmi.dialect.Problems;

/** A state machine of a UML 1.x file, as it stands there. */
record Uml14Machine(Uml14Element element) implements DrawnMachine {

    @Override
    public String id() {
        return element.id();
    }

    @Override
    public String name() {
        return element.name();
    }

    @Override
    public int line() {
        return element.line();
    }

    @Override
    public Statechart statechart(String title, Problems problems) {
        return new Uml14ChartReader(problems).read(element, title);
    }
}
