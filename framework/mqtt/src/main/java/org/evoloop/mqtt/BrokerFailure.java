package org.evoloop.mqtt;

import com.hivemq.client.mqtt.exceptions.ConnectionClosedException;
import com.hivemq.client.mqtt.exceptions.MqttDecodeException;
import com.hivemq.client.mqtt.mqtt3.exceptions.Mqtt3ConnAckException;
import com.hivemq.client.mqtt.mqtt3.exceptions.Mqtt3SubAckException;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5ConnAckException;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5DisconnectException;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5PubAckException;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5SubAckException;
import com.hivemq.client.mqtt.mqtt5.message.connect.connack.Mqtt5ConnAckReasonCode;
import com.hivemq.client.mqtt.mqtt5.message.disconnect.Mqtt5DisconnectReasonCode;
import com.hivemq.client.mqtt.mqtt5.message.publish.puback.Mqtt5PubAckReasonCode;
import java.net.ConnectException;
import java.net.UnknownHostException;
import java.security.cert.CertificateException;
import javax.net.ssl.SSLException;
import org.jspecify.annotations.Nullable;

/** Describes a problem with a broker, and what to do. */
final class BrokerFailure {
    private BrokerFailure() {}

    /** Whether the broker has refused a message permanently. */
    static boolean isDenial(@Nullable Throwable failure) {
        return failure instanceof Mqtt5PubAckException denied
                && denied.getMqttMessage().getReasonCode() != Mqtt5PubAckReasonCode.QUOTA_EXCEEDED;
    }

    /** Whether a login with MQTT 5 may have failed since the broker only knows MQTT 3.1.1. */
    static boolean mayBeOld(@Nullable Throwable failure) {
        return failure instanceof Mqtt5ConnAckException refused
                ? refused.getMqttMessage().getReasonCode() == Mqtt5ConnAckReasonCode.UNSUPPORTED_PROTOCOL_VERSION
                : failure instanceof ConnectionClosedException || failure instanceof MqttDecodeException;
    }

    /** Whether a broker that knows MQTT 3.1.1 has refused a login with it. */
    static boolean isAnswer(@Nullable Throwable failure) {
        return failure instanceof Mqtt3ConnAckException || failure instanceof Mqtt3SubAckException;
    }

    static String describe(BrokerAddress address, @Nullable Throwable failure) {
        for (Throwable cause = failure; cause != null; cause = cause.getCause()) {
            String known = known(address, cause);
            if (known != null) {
                return known;
            }
        }
        return address + ": " + (failure == null ? "the connection is gone" : text(failure));
    }

    private static @Nullable String known(BrokerAddress address, Throwable cause) {
        if (cause instanceof Mqtt5ConnAckException refused) {
            return refused(address, refused.getMqttMessage().getReasonCode());
        }
        if (cause instanceof Mqtt3ConnAckException refused) {
            return switch (refused.getMqttMessage().getReturnCode()) {
                case BAD_USER_NAME_OR_PASSWORD, NOT_AUTHORIZED -> refusedLogin(address);
                default ->
                    address + " refuses the connection: "
                            + refused.getMqttMessage().getReturnCode();
            };
        }
        if (cause instanceof Mqtt3SubAckException) {
            return address + " does not let " + user(address) + " subscribe; check the broker's access list";
        }
        if (cause instanceof Mqtt5DisconnectException left) {
            return left.getMqttMessage().getReasonCode() == Mqtt5DisconnectReasonCode.SESSION_TAKEN_OVER
                    ? address
                            + ": another program has logged in with the same id; give one of them another, with ?id=ID"
                    : address + " has ended the connection: "
                            + left.getMqttMessage().getReasonCode();
        }
        if (cause instanceof ConnectionClosedException) {
            return address
                    + " has ended the connection; if it keeps doing so, another program may have the same id: give "
                    + "one of them another, with ?id=ID";
        }
        if (cause instanceof Mqtt5SubAckException denied) {
            return address + " does not let " + user(address) + " subscribe: "
                    + denied.getMqttMessage().getReasonCodes() + "; check the broker's access list";
        }
        if (cause instanceof Mqtt5PubAckException denied) {
            return address + " does not let " + user(address) + " publish: "
                    + denied.getMqttMessage().getReasonCode() + "; check the broker's access list and its disk";
        }
        if (cause instanceof CertificateException) {
            return address + ": the broker's certificate is not trusted: " + text(cause)
                    + "; ?ca=FILE names the certificates that it is signed with, ?sha256=FINGERPRINT its own";
        }
        if (cause instanceof SSLException && cause.getCause() == null) {
            return address + ": there is no TLS with this broker: " + text(cause)
                    + "; check the port, or begin the URL with mqtt:// if the broker has none";
        }
        if (cause instanceof UnknownHostException) {
            return address + ": there is no computer of this name; check the URL and the network";
        }
        if (cause instanceof ConnectException) {
            return address + " cannot be reached; check that the broker runs there, and the port";
        }
        return null;
    }

    private static String refused(BrokerAddress address, Mqtt5ConnAckReasonCode code) {
        return switch (code) {
            case BAD_USER_NAME_OR_PASSWORD, NOT_AUTHORIZED -> refusedLogin(address);
            case UNSUPPORTED_PROTOCOL_VERSION ->
                address + " knows neither MQTT 5 nor MQTT 3.1.1; a newer broker does, such as Mosquitto";
            default -> address + " refuses the connection: " + code;
        };
    }

    private static String refusedLogin(BrokerAddress address) {
        return address + " refuses the login of " + user(address)
                + "; check the user in the URL, and the password in --mqtt-password-file or "
                + MqttOptions.PASSWORD.variable();
    }

    private static String user(BrokerAddress address) {
        return address.user() == null ? "a client without a user" : "user " + address.user();
    }

    private static String text(Throwable cause) {
        String message = cause.getMessage();
        return message == null ? cause.getClass().getSimpleName() : message.replaceAll("\\s+", " ");
    }
}
