package org.evoloop.console;

import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/**
 * Makes termination signals run an action instead, so that the process can end in its own order and with its own exit
 * status. {@link #restore} restores the former handlers.
 *
 * <p>The JDK's signal API is not a supported part of the platform, hence the reflection; on a machine without it,
 * signals end the process as usual.
 *
 * <p>Threading: for one thread.
 *
 * @since 0.1
 */
public final class TerminationSignals {
    private static final List<String> NAMES = List.of("INT", "TERM", "HUP");

    private final Map<Object, Object> former = new LinkedHashMap<>();

    /** @param action called with the signal's name on a thread of its own, once for each signal */
    public TerminationSignals(Consumer<String> action) {
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
                // This machine does not have the signal, or its JVM reserves it.
            }
        }
    }

    private static Object handle(Object signal, Object handler) throws ReflectiveOperationException {
        Class<?> type = signal.getClass();
        Method handle = type.getMethod("handle", type, Class.forName("sun.misc.SignalHandler"));
        return handle.invoke(null, signal, handler);
    }

    /** Makes signals do what they did before. */
    public void restore() {
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
