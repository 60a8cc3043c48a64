package org.evoloop.models.temporal;

import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import net.automatalib.graph.impl.CompactPMPG;
import net.automatalib.graph.impl.DefaultCFMPS;
import net.automatalib.modelchecker.m3c.formula.AndNode;
import net.automatalib.modelchecker.m3c.formula.AtomicNode;
import net.automatalib.modelchecker.m3c.formula.BoxNode;
import net.automatalib.modelchecker.m3c.formula.FalseNode;
import net.automatalib.modelchecker.m3c.formula.FormulaNode;
import net.automatalib.modelchecker.m3c.formula.NotNode;
import net.automatalib.modelchecker.m3c.formula.OrNode;
import net.automatalib.modelchecker.m3c.formula.TrueNode;
import net.automatalib.modelchecker.m3c.formula.ctl.AFNode;
import net.automatalib.modelchecker.m3c.formula.ctl.AGNode;
import net.automatalib.modelchecker.m3c.formula.ctl.AUNode;
import net.automatalib.modelchecker.m3c.formula.ctl.AWUNode;
import net.automatalib.modelchecker.m3c.formula.ctl.EFNode;
import net.automatalib.modelchecker.m3c.solver.M3CSolvers;
import net.automatalib.ts.modal.transition.ModalEdgeProperty.ModalType;
import net.automatalib.ts.modal.transition.ProceduralModalEdgeProperty.ProceduralType;
import net.automatalib.ts.modal.transition.impl.ProceduralModalEdgePropertyImpl;
import org.evoloop.check.temporal.Formula;
import org.evoloop.check.temporal.Formula.Atom;
import org.evoloop.check.temporal.Moment;
import org.evoloop.check.temporal.MomentGraph;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.ModelException;

/**
 * Asks M3C, the model checker of AutomataLib, whether a formula holds in a moment. Plain propositions are looked up;
 * M3C decides all temporal formulas.
 *
 * <p>Threading: not thread-safe; it remembers the answers.
 */
final class ModelChecker {
    private static final String MAIN = "main";

    private final ModelPair pair;
    private final MomentGraph graph;
    private final Map<Formula, Map<Moment, Boolean>> answers = new HashMap<>();

    ModelChecker(ModelPair pair, MomentGraph graph) {
        this.pair = pair;
        this.graph = graph;
    }

    /** Whether {@code formula} holds in {@code moment}. */
    boolean holds(Formula formula, Moment moment) {
        if (formula.isPlain()) {
            return formula.isSeenIn(moment, pair);
        } else if (formula instanceof Formula.Not not) {
            return !holds(not.operand(), moment);
        } else if (formula instanceof Formula.And and) {
            return holds(and.left(), moment) && holds(and.right(), moment);
        } else if (formula instanceof Formula.Or or) {
            return holds(or.left(), moment) || holds(or.right(), moment);
        }
        return answers.computeIfAbsent(formula, asked -> new HashMap<>())
                .computeIfAbsent(moment, at -> ask(formula, at));
    }

    private boolean ask(Formula formula, Moment moment) {
        Collection<Atom> atoms = atoms(formula);
        CompactPMPG<String, Atom> kripke = new CompactPMPG<>(MAIN);
        Map<Moment, Integer> nodes = new HashMap<>();
        for (Moment known : graph.moments()) {
            Set<Atom> shown = new HashSet<>(atoms);
            shown.removeIf(atom -> !known.shows(atom, pair));
            nodes.put(known, kripke.addNode(shown));
        }
        for (Moment known : graph.moments()) {
            for (MomentGraph.Edge edge : graph.from(known)) {
                kripke.setEdgeLabel(
                        kripke.connect(
                                nodes.get(known),
                                nodes.get(edge.target()),
                                new ProceduralModalEdgePropertyImpl(ProceduralType.INTERNAL, ModalType.MUST)),
                        "");
            }
        }
        kripke.setInitialNode(nodes.get(moment));
        // M3C requires a final node. The converter has none, so no edge leads to this one.
        kripke.setFinalNode(kripke.addNode(Set.of()));
        return solve(new DefaultCFMPS<>(MAIN, Map.of(MAIN, kripke)), translate(formula));
    }

    /** Uses M3C's ADD solver. Its BDD solver is wrong about negations, see {@code docs/adr}. */
    private static boolean solve(DefaultCFMPS<String, Atom> system, FormulaNode<String, Atom> formula) {
        try {
            return M3CSolvers.typedADDSolver(system).solve(formula);
        } catch (IllegalStateException noBackend) {
            throw new ModelException(
                    "properties cannot be checked on this machine: the decision diagrams that this takes exist for Linux, "
                            + "macOS and Windows on x86-64",
                    noBackend);
        }
    }

    private static FormulaNode<String, Atom> translate(Formula formula) {
        if (formula instanceof Formula.Constant constant) {
            return constant.value() ? new TrueNode<>() : new FalseNode<>();
        } else if (formula instanceof Atom atom) {
            return new AtomicNode<>(atom);
        } else if (formula instanceof Formula.Not not) {
            return new NotNode<>(translate(not.operand()));
        } else if (formula instanceof Formula.And and) {
            return new AndNode<>(translate(and.left()), translate(and.right()));
        } else if (formula instanceof Formula.Or or) {
            return new OrNode<>(translate(or.left()), translate(or.right()));
        } else if (formula instanceof Formula.Always always) {
            return new AGNode<>(translate(always.operand()));
        } else if (formula instanceof Formula.Can can) {
            return new EFNode<>(translate(can.operand()));
        } else if (formula instanceof Formula.Eventually eventually) {
            return new AFNode<>(translate(eventually.operand()));
        } else if (formula instanceof Formula.Next next) {
            return new BoxNode<>(translate(next.operand()));
        } else if (formula instanceof Formula.Unless unless) {
            return new AWUNode<>(translate(unless.left()), translate(unless.right()));
        } else if (formula instanceof Formula.Until until) {
            return new AUNode<>(translate(until.left()), translate(until.right()));
        }
        throw new AssertionError(formula);
    }

    private static Set<Atom> atoms(Formula formula) {
        Set<Atom> atoms = new LinkedHashSet<>();
        if (formula instanceof Atom atom) {
            atoms.add(atom);
        }
        formula.operands().forEach(operand -> atoms.addAll(atoms(operand)));
        return atoms;
    }
}
