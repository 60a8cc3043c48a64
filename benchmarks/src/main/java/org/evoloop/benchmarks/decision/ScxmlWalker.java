package org.evoloop.benchmarks.decision;

import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import org.apache.commons.scxml.Context;
import org.apache.commons.scxml.Evaluator;
import org.apache.commons.scxml.SCXMLExecutor;
import org.apache.commons.scxml.SCXMLListener;
import org.apache.commons.scxml.TriggerEvent;
import org.apache.commons.scxml.env.SimpleContext;
import org.apache.commons.scxml.env.SimpleDispatcher;
import org.apache.commons.scxml.env.SimpleErrorReporter;
import org.apache.commons.scxml.model.ModelException;
import org.apache.commons.scxml.model.SCXML;
import org.apache.commons.scxml.model.State;
import org.apache.commons.scxml.model.Transition;
import org.apache.commons.scxml.model.TransitionTarget;
import org.jspecify.annotations.Nullable;
import org.w3c.dom.Node;

/** commons-scxml 0.9, with a model built without a file. */
final class ScxmlWalker extends Walker {
    private final SCXMLExecutor executor;

    @SuppressWarnings("unchecked") // the library is older than generics
    ScxmlWalker(Walk walk) {
        SCXML document = new SCXML();
        Map<String, State> states = new HashMap<>();
        for (String name : walk.states()) {
            State state = new State();
            state.setId(name);
            document.addChild(state);
            document.addTarget(state);
            states.put(name, state);
        }
        for (Walk.Move move : walk.moves()) {
            Transition transition = new Transition();
            transition.setEvent(move.event());
            transition.setNext(move.target());
            transition.getTargets().add(Objects.requireNonNull(states.get(move.target())));
            Objects.requireNonNull(states.get(move.source())).addTransition(transition);
        }
        document.setInitialTarget(states.get(walk.initial()));
        executor = new SCXMLExecutor(new NoExpressions(), new SimpleDispatcher(), new SimpleErrorReporter());
        executor.setStateMachine(document);
        executor.setRootContext(new SimpleContext());
        executor.addListener(document, new Counter());
        try {
            executor.go();
        } catch (ModelException broken) {
            throw new IllegalStateException(broken);
        }
    }

    @Override
    void fire(String event) {
        try {
            executor.triggerEvent(new TriggerEvent(event, TriggerEvent.SIGNAL_EVENT));
        } catch (ModelException broken) {
            throw new IllegalStateException(broken);
        }
    }

    private final class Counter implements SCXMLListener {
        @Override
        public void onEntry(TransitionTarget entered) {}

        @Override
        public void onExit(TransitionTarget left) {}

        @Override
        public void onTransition(TransitionTarget from, TransitionTarget to, @Nullable Transition transition) {
            act();
        }
    }

    /** The walks have no guards. */
    private static final class NoExpressions implements Evaluator {
        @Override
        public Object eval(Context context, String expression) {
            return expression;
        }

        @Override
        public Boolean evalCond(Context context, String expression) {
            return Boolean.TRUE;
        }

        @Override
        public Node evalLocation(Context context, String expression) {
            throw new UnsupportedOperationException(expression);
        }

        @Override
        public Context newContext(@Nullable Context parent) {
            return new SimpleContext(parent);
        }
    }
}
