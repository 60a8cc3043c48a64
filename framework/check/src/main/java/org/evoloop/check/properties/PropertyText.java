package org.evoloop.check.properties;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.evoloop.check.temporal.FormulaParser;
import org.evoloop.check.temporal.Property;
import org.evoloop.check.temporal.Word;
import org.evoloop.check.timing.Assumption;
import org.evoloop.check.timing.Reaction;
import org.evoloop.check.timing.TimeForm;
import org.evoloop.check.timing.TimeProperty;
import org.evoloop.check.timing.TimeRules;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.ModelException;

/** Parses the text of a property file: one property per line, {@code name: formula}, continued on indented lines. */
final class PropertyText {
    private final FormulaParser formulas;
    private final TimeFormParser forms;
    private final AssumptionParser facts;
    private final Agreement agreement;
    private final String file;
    private final List<Property> properties = new ArrayList<>();
    private final List<TimeProperty> timed = new ArrayList<>();
    private final List<Assumption> assumptions = new ArrayList<>();
    private final List<Reaction> reactions = new ArrayList<>();
    private final List<String> problems = new ArrayList<>();
    private final StringBuilder pending = new StringBuilder();
    private int pendingLine;

    private PropertyText(String file, ModelPair pair) {
        this.file = file;
        this.formulas = new FormulaParser(pair);
        this.forms = new TimeFormParser(formulas);
        this.facts = new AssumptionParser(pair, formulas);
        this.agreement = new Agreement(file);
    }

    /**
     * What is written.
     *
     * @param file for messages
     * @throws ModelException naming file, line and remedy for everything that cannot be understood
     */
    static PropertyText parse(String file, String text, ModelPair pair) {
        PropertyText reader = new PropertyText(file, pair);
        List<String> lines = text.lines().toList();
        for (int index = 0; index < lines.size(); index++) {
            reader.line(lines.get(index), index + 1);
        }
        reader.flush();
        reader.problems.addAll(reader.agreement.problems());
        if (!reader.problems.isEmpty()) {
            throw new ModelException(String.join("\n", reader.problems));
        }
        return reader;
    }

    List<Property> properties() {
        return List.copyOf(properties);
    }

    TimeRules time() {
        return new TimeRules(timed, assumptions, reactions);
    }

    private void line(String line, int number) {
        String content = line.strip();
        if (content.isEmpty() || content.startsWith("#")) {
            return;
        }
        if (!Character.isWhitespace(line.charAt(0))) {
            flush();
            pendingLine = number;
        }
        pending.append(content).append(' ');
    }

    private void flush() {
        String text = pending.toString().strip();
        pending.setLength(0);
        if (text.isEmpty()) {
            return;
        }
        int colon = colon(text);
        String name = colon < 0 ? text : text.substring(0, colon).strip();
        try {
            read(name, text.substring(colon + 1));
        } catch (ModelException problem) {
            problems.add(file + ", line " + pendingLine + ": " + problem.getMessage());
        }
    }

    /** The end of the name; a colon in quotation marks is part of a name from the models. */
    private static int colon(String text) {
        int colon = text.indexOf(':');
        long quotes = colon < 0
                ? 0
                : text.substring(0, colon).chars().filter(each -> each == '"').count();
        return quotes % 2 == 0 ? colon : -1;
    }

    private void read(String name, String text) {
        Optional<Reaction> reaction = facts.reaction(text);
        if (reaction.isPresent()) {
            reactions.add(reaction.get());
            agreement.add(reaction.get(), pendingLine);
            return;
        }
        List<Word> words = Word.of(text);
        Optional<Assumption> assumption = facts.assumption(words);
        if (assumption.isPresent()) {
            assumptions.add(assumption.get());
            agreement.add(assumption.get(), pendingLine);
            return;
        }
        Optional<TimeForm> form = forms.parse(words);
        if (form.isPresent()) {
            TimeProperty property = new TimeProperty(name, form.get(), pendingLine);
            timed.add(property);
            agreement.add(property);
        } else {
            properties.add(new Property(name, formulas.parse(words), pendingLine));
        }
    }
}
