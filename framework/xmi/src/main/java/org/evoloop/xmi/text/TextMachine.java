package org.evoloop.xmi.text;

import org.evoloop.statechart.Statechart;
import org.evoloop.xmi.dialect.DrawnMachine;
import org.evoloop.xmi.dialect.Problems;

/** The state machine of a block of text. */
record TextMachine(TextBlock block) implements DrawnMachine {

    /** The line, as in links to a place in a text: {@code L12}. */
    @Override
    public String id() {
        return "L" + block.line();
    }

    @Override
    public String name() {
        return block.title();
    }

    @Override
    public int line() {
        return block.line();
    }

    @Override
    public Statechart statechart(String title, Problems problems) {
        return new Statements(block, problems).chart(title);
    }
}
