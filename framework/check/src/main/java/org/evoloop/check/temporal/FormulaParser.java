package org.evoloop.check.temporal;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.check.temporal.Formula.Kind;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * Parses a formula; the operators, from lowest to highest precedence:
 *
 * <pre>
 * always F   never F                      the rest of the brackets
 * F implies G
 * F unless G   F until G   F only after G
 * F or G
 * F and G
 * not F   can F   eventually F   next F
 * Spot   state Spot   device On   event Clean   function Move   true   false   (F)
 * </pre>
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class FormulaParser {
    private static final Set<String> KEYWORDS = Set.of(
            "always",
            "never",
            "implies",
            "unless",
            "until",
            "only",
            "after",
            "or",
            "and",
            "not",
            "can",
            "eventually",
            "next",
            "state",
            "device",
            "event",
            "function",
            "true",
            "false",
            "(",
            ")");

    private final ModelPair pair;
    private List<Word> words = List.of();
    private int position;

    /** @param pair the models whose states and events formulas name */
    public FormulaParser(ModelPair pair) {
        this.pair = pair;
    }

    /**
     * Parses the words of a formula.
     *
     * @throws ModelException saying what is wrong and where in the formula
     */
    public Formula parse(List<Word> formula) {
        words = formula;
        position = 0;
        Formula read = formula();
        if (position < words.size()) {
            throw unexpected("'and', 'or', 'implies' or the end");
        }
        return read;
    }

    /**
     * The atom for {@code name}.
     *
     * @throws ModelException if nothing of this kind has that name; the message lists the names
     */
    public Formula.Atom known(Kind kind, String name) {
        Set<String> names = names(kind);
        if (!names.contains(name)) {
            String what = switch (kind) {
                case STATE -> "state of the new model";
                case DEVICE -> "state of the original model";
                case EVENT -> "event of the new model";
                case FUNCTION -> "new state";
            };
            throw new ModelException(
                    "there is no " + what + " named " + name + "; there are " + String.join(", ", names));
        }
        return new Formula.Atom(kind, name);
    }

    private Formula formula() {
        if (take("always")) {
            return new Formula.Always(formula());
        }
        if (take("never")) {
            return new Formula.Always(new Formula.Not(formula()));
        }
        Formula left = weak();
        return take("implies") ? new Formula.Or(new Formula.Not(left), formula()) : left;
    }

    private Formula weak() {
        Formula left = or();
        if (take("unless")) {
            return new Formula.Unless(left, or());
        }
        if (take("until")) {
            return new Formula.Until(left, or());
        }
        if (take("only")) {
            if (!take("after")) {
                throw unexpected("'after'");
            }
            return new Formula.Unless(new Formula.Not(left), or());
        }
        return left;
    }

    private Formula or() {
        Formula left = and();
        while (take("or")) {
            left = new Formula.Or(left, and());
        }
        return left;
    }

    private Formula and() {
        Formula left = unary();
        while (take("and")) {
            left = new Formula.And(left, unary());
        }
        return left;
    }

    private Formula unary() {
        if (take("not")) {
            return new Formula.Not(unary());
        }
        if (take("can")) {
            return new Formula.Can(unary());
        }
        if (take("eventually")) {
            return new Formula.Eventually(unary());
        }
        if (take("next")) {
            return new Formula.Next(unary());
        }
        if (take("(")) {
            Formula inner = formula();
            if (!take(")")) {
                throw unexpected("')'");
            }
            return inner;
        }
        return atom();
    }

    private Formula atom() {
        if (take("true")) {
            return new Formula.Constant(true);
        }
        if (take("false")) {
            return new Formula.Constant(false);
        }
        for (Kind kind : Kind.values()) {
            if (take(kind.name().toLowerCase(Locale.ROOT))) {
                return known(kind, name());
            }
        }
        return known(Kind.STATE, name());
    }

    private Set<String> names(Kind kind) {
        return switch (kind) {
            case STATE -> names(pair.evolved(), state -> true);
            case DEVICE -> names(pair.original(), state -> true);
            case EVENT ->
                pair.evolved().triggers().stream()
                        .map(event -> event.name())
                        .collect(Collectors.toCollection(java.util.TreeSet::new));
            case FUNCTION -> names(pair.evolved(), pair::isNew);
        };
    }

    private static Set<String> names(StateMachine machine, Predicate<State> wanted) {
        return machine.states().stream()
                .filter(wanted)
                .flatMap(state -> Stream.of(state, machine.withoutMemory(state)))
                .map(State::name)
                .collect(Collectors.toCollection(java.util.TreeSet::new));
    }

    private String name() {
        Word word = next().filter(FormulaParser::isName).orElseThrow(() -> unexpected("a name"));
        position++;
        return word.text();
    }

    private static boolean isName(Word word) {
        return word.quoted() || !KEYWORDS.contains(word.text());
    }

    private boolean take(String keyword) {
        boolean found = next().filter(word -> word.is(keyword)).isPresent();
        if (found) {
            position++;
        }
        return found;
    }

    private Optional<Word> next() {
        return position < words.size() ? Optional.of(words.get(position)) : Optional.empty();
    }

    private ModelException unexpected(String wanted) {
        String found = next().map(word -> "'" + word.text() + "'").orElse("the end");
        return new ModelException(found + " stands where " + wanted + " should"
                + (position == 0 ? "" : ", after '" + words.get(position - 1).text() + "'")
                + "; write names that are words of the language in quotation marks");
    }
}
