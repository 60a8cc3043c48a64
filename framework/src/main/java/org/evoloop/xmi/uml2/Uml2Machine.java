package org.evoloop.xmi.uml2;

import org.evoloop.statechart.Statechart;
import org.evoloop.xmi.dialect.DrawnMachine;
import org.evoloop.xmi.dialect.Problems;

/** A state machine of a UML 2 file, as it stands there. */
record Uml2Machine(Uml2Element element) implements DrawnMachine {

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
        return new Uml2ChartReader(new Uml2References(problems), problems).read(element, title);
    }
}
