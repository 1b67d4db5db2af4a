//! Evaluation of compiled expressions.

use super::super::ast::Found;
use super::super::command::{CmdId, Imp};
use super::super::core::{Core, NsId};
use super::super::error::Exception;
use super::super::interp::Interp;
use super::super::number::Number;
use super::super::value::{Rep, Value};
use super::{Expr, Function, Op, Range, arith, compile, compile_text, func};

impl<H> Interp<H> {
    /// Evaluate an expression that will be evaluated again, such as the condition of a loop.
    pub(crate) fn expr(&mut self, value: &Value) -> Result<Value, Exception> {
        if let Rep::Int(_) | Rep::Double(_) = value.0 {
            return Ok(self.numeric(value.clone()));
        }
        let expr = compile(value).map_err(|e| e.at(None, ""))?;
        self.result_of(&expr, &[])
    }

    /// The result of a compiled expression.
    #[inline]
    pub(crate) fn result_of(&mut self, expr: &Expr, operands: &[Value]) -> Result<Value, Exception> {
        if let Some(n) = self.core.number_of(expr, operands) {
            return Ok(n.into());
        }
        let result = self.evaluate(expr, operands)?;
        self.finish(result)
    }

    /// Evaluate an expression whose text was put together just now.
    pub(crate) fn expr_text(&mut self, text: &str) -> Result<Value, Exception> {
        let expr = compile_text(text)?;
        let result = self.evaluate(&expr, &[])?;
        self.finish(result)
    }

    /// The condition of `if`, `while` and `for`.
    pub(crate) fn condition(&mut self, value: &Value) -> Result<bool, Exception> {
        if let Rep::Int(i) = value.0 {
            return Ok(i != 0);
        }
        self.holds(&*compile(value)?)
    }

    /// The truth of a compiled condition.
    #[inline]
    pub(crate) fn holds(&mut self, expr: &Expr) -> Result<bool, Exception> {
        if let Some(n) = self.core.number_of(expr, &[]) {
            return Ok(n.is_true());
        }
        let result = self.evaluate(expr, &[])?;
        match result.0 {
            Rep::Int(i) => Ok(i != 0),
            _ => result.to_bool().map_err(|e| e.at(expr.unit.span(0, expr.unit.text.len() as u32), "")),
        }
    }

    /// Results that are numbers are given in Tcl's own spelling; what is no number at the end is an error.
    pub(super) fn finish(&self, value: Value) -> Result<Value, Exception> {
        let value = self.numeric(value);
        match &value.0 {
            Rep::Double(d) if d.get().is_nan() => Err(arith::domain_error()),
            _ => Ok(value),
        }
    }

    fn numeric(&self, value: Value) -> Value {
        match &value.0 {
            Rep::Double(d) if self.core.precision > 0 => self.core.double(d.get()),
            Rep::Str(_) => match value.number() {
                Some(Number::Double(d)) => self.core.double(d),
                Some(n) => Value::from(n),
                None => value,
            },
            _ => value,
        }
    }

    pub(super) fn evaluate(&mut self, expr: &Expr, slots: &[Value]) -> Result<Value, Exception> {
        let mut stack = self.core.take_words();
        let result = self.operate(expr, slots, &mut stack);
        self.core.give_words(stack);
        result
    }

    fn operate(&mut self, expr: &Expr, slots: &[Value], stack: &mut Vec<Value>) -> Result<Value, Exception> {
        let mut at = 0;
        while let Some(op) = expr.ops.get(at) {
            let place = expr.places.get(at).copied().unwrap_or_default();
            at += 1;
            match op {
                Op::Push(v) => stack.push(v.clone()),
                Op::Slot(number) => stack.push(slots.get(*number).cloned().unwrap_or_default()),
                Op::Var(var) => stack.push(self.variable(&expr.unit, var)?),
                Op::Script(script) => stack.push(self.run(script)?),
                Op::Parts(parts) => stack.push(Value::from(self.join(&expr.unit, parts)?)),
                Op::Unary(op) => {
                    if let Some(top) = stack.last_mut() {
                        *top = arith::unary(*op, top).map_err(|e| e.at(expr.right(place), ""))?;
                    }
                }
                Op::Binary(op) => {
                    let right = stack.pop().unwrap_or_default();
                    if let Some(left) = stack.last_mut() {
                        *left = match arith::binary(*op, left, &right) {
                            Ok(value) => value,
                            Err(fault) => {
                                let span = match fault.side {
                                    arith::Side::Left => expr.left(place),
                                    arith::Side::Right => expr.right(place),
                                };
                                return Err(fault.error.at(span, ""));
                            }
                        };
                    }
                }
                Op::Function(function) => {
                    let from = stack.len().saturating_sub(function.args);
                    let value = if self.core.is_of_the_language(function) {
                        match (function.known, stack.get(from..)) {
                            (Some(func::Known::Real(real)), Some([Value(Rep::Double(x))])) if !x.get().is_nan() => {
                                func::finite(real(x.get()))
                            }
                            (_, args) => func::call(&mut self.core, &function.name, args.unwrap_or_default()),
                        }
                    } else {
                        self.function(function, stack.split_off(from))
                    };
                    stack.truncate(from);
                    stack.push(value.map_err(|e| e.at(expr.unit.span(place.start, place.end), ""))?);
                }
                Op::And(end) | Op::Or(end) => {
                    let is_or = matches!(op, Op::Or(_));
                    let truth = self.truth(expr, place, stack.pop())?;
                    if truth == is_or {
                        stack.push(Value::from(truth));
                        at = *end as usize;
                    }
                }
                Op::Truth => {
                    let truth = self.truth(expr, place, stack.pop())?;
                    stack.push(Value::from(truth));
                }
                Op::Else(other) => {
                    if !self.truth(expr, place, stack.pop())? {
                        at = *other as usize;
                    }
                }
                Op::Jump(to) => at = *to as usize,
            }
        }
        Ok(stack.pop().unwrap_or_default())
    }

    fn truth(&self, expr: &Expr, place: Range, value: Option<Value>) -> Result<bool, Exception> {
        let value = value.unwrap_or_default();
        match value.0 {
            Rep::Int(i) => Ok(i != 0),
            _ => value.to_bool().map_err(|e| e.at(expr.unit.span(place.start, place.end), "")),
        }
    }

    /// Call a math function: one of the script's own, `proc tcl::mathfunc::name`, or one of Tcl's.
    fn function(&mut self, function: &Function, args: Vec<Value>) -> Result<Value, Exception> {
        let ns = self.core.here();
        let local = format!("tcl::mathfunc::{}", function.name);
        let id = self
            .core
            .find_command_from(ns, &local)
            .or_else(|| self.core.find_command_from(NsId::GLOBAL, &local))
            .map(|id| self.core.origin_of(id));
        let own = match id.map(|id| (id, &self.core.table.commands[id.0 as usize].imp)) {
            Some((_, Imp::Core(f))) if std::ptr::fn_addr_eq(*f, func::command as super::super::command::CoreFn) => None,
            Some((id, _)) => Some(id),
            None if self.core.find_command("::unknown").is_some() => {
                let mut argv = vec![Value::from(local)];
                argv.extend(args);
                return self.invoke(argv, None);
            }
            None => {
                let near = crate::diagnostic::nearest(&function.name, func::names()).map(str::to_owned);
                let e = Exception::coded(
                    format!("invalid command name \"{local}\""),
                    &["TCL", "LOOKUP", "COMMAND", &local],
                );
                let told = format!("unknown math function \"{}\"", function.name);
                return Err(e.map_error(|e| e.diagnostic.message = told).suggest(&function.name, near));
            }
        };
        match own {
            Some(id) => self.call_function(id, &local, args),
            None => {
                let found = Found { epoch: self.core.table.epoch, namespace: ns.0, command: u32::MAX };
                function.found.set(found);
                func::call(&mut self.core, &function.name, &args)
            }
        }
    }

    fn call_function(&mut self, id: CmdId, name: &str, args: Vec<Value>) -> Result<Value, Exception> {
        let mut argv = vec![Value::from(name)];
        argv.extend(args);
        self.invoke_command(id, argv, None)
    }
}

impl Core {
    /// Returns true if a math function was found to be Tcl's own and nothing was defined since.
    pub(super) fn is_of_the_language(&self, function: &Function) -> bool {
        let found = function.found.get();
        found.epoch == self.table.epoch && found.namespace == self.here().0 && found.command == u32::MAX
    }
}

impl Expr {
    /// Place of the left operand of a binary operation.
    fn left(&self, place: Range) -> Option<crate::diagnostic::Span> {
        let text = self.unit.slice(place.start, place.operator.0);
        let length = text.trim_end().len() as u32;
        self.unit.span(place.start, place.start + length)
    }

    /// Place of the right or only operand.
    fn right(&self, place: Range) -> Option<crate::diagnostic::Span> {
        let text = self.unit.slice(place.operator.1, place.end);
        let blanks = (text.len() - text.trim_start().len()) as u32;
        self.unit.span(place.operator.1 + blanks, place.end)
    }
}
