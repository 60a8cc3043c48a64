package org.evoloop.console;

import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/**
 * Signals that ask the process to end run an action instead, so that it can end in its own order and with its own exit
 * status. {@link #restore} brings the former handlers back.
 *
 * <p>The JDK's signals are no part of the platform that one may compile against, hence the reflection; on a machine
 * without them signals end the process as usual.
 */
final class TerminationSignals {
    private static final List<String> NAMES = List.of("INT", "TERM", "HUP");

    private final Map<Object, Object> former = new LinkedHashMap<>();

    /** @param action called with the signal's name on a thread of its own, once a signal */
    TerminationSignals(Consumer<String> action) {
        for (String name : NAMES) {
            try {
                Class<?> handler = Class.forName("sun.misc.SignalHandler");
                Object signal = Class.forName("sun.misc.Signal")
                        .getConstructor(String.class)
                        .newInstance(name);
                Object own = Proxy.newProxyInstance(
                        handler.getClassLoader(), new Class<?>[] {handler}, (proxy, method, arguments) -> {
                            action.accept(name);
                            return null;
                        });
                former.put(signal, handle(signal, own));
            } catch (ReflectiveOperationException unsupported) {
                // This machine does not know the signal, or its virtual machine keeps it to itself.
            }
        }
    }

    private static Object handle(Object signal, Object handler) throws ReflectiveOperationException {
        Class<?> type = signal.getClass();
        Method handle = type.getMethod("handle", type, Class.forName("sun.misc.SignalHandler"));
        return handle.invoke(null, signal, handler);
    }

    void restore() {
        former.forEach((signal, handler) -> {
            try {
                handle(signal, handler);
            } catch (ReflectiveOperationException impossible) {
                throw new IllegalStateException("signal " + signal + " could not be given back", impossible);
            }
        });
        former.clear();
    }
}
