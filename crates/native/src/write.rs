//! Code generation for a piece of a tape.

use crate::pieces::{Pieces, place};
use cranelift_codegen::control::ControlPlane;
use cranelift_codegen::ir::{
    AbiParam, ConstantData, Function, InstBuilder, MemFlags, SigRef, Signature, UserFuncName, Value, types,
};
use cranelift_codegen::isa::OwnedTargetIsa;
use cranelift_codegen::{Context, ir};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use field::{Analytic, Elementary};
use symbolic::{Operation, Register, Tape};

/// The size of a number in bytes.
const NUMBER: i32 = 8;
/// The caller's slices are aligned, and memory that is read is never written: loads may be moved to their first use.
const MEMORY: MemFlags = MemFlags::trusted().with_readonly().with_can_move();
/// Two adjacent numbers have the alignment of one.
const TOGETHER: MemFlags = MemFlags::new().with_notrap();

/// A piece writes each value for later pieces once and does not read it.
const KEPT: MemFlags = MemFlags::trusted();

/// The machine code of one piece.
pub struct Written {
    pub instructions: Vec<u8>,
    /// The stack frame in bytes.
    pub frame: u32,
}

/// The code of a function `(state, time, outputs, constants, buffer)` that refers only to itself and the functions
/// below; `None` where the code generator fails.
pub fn instructions(tape: &Tape, pieces: &Pieces, piece: usize, isa: &OwnedTargetIsa) -> Option<Written> {
    let (pointer, convention) = (isa.pointer_type(), isa.default_call_conv());
    let signature = |takes: &[ir::Type], gives: &[ir::Type]| {
        let mut signature = Signature::new(convention);
        signature.params.extend(takes.iter().map(|each| AbiParam::new(*each)));
        signature.returns.extend(gives.iter().map(|each| AbiParam::new(*each)));
        signature
    };
    let entry = signature(&[pointer, types::F64, pointer, pointer, pointer], &[]);
    let circle = signature(&[types::F64], &[types::F64, types::F64]);
    let mut context = Context::for_function(Function::with_name_signature(UserFuncName::default(), entry));
    let mut builder = FunctionBuilderContext::new();
    let mut code = FunctionBuilder::new(&mut context.func, &mut builder);
    let angle_to_point = code.import_signature(circle);
    let pair_to_number = code.import_signature(signature(&[types::F64, types::F64], &[types::F64]));
    let block = code.create_block();
    code.append_block_params_for_function_params(block);
    code.switch_to_block(block);
    code.seal_block(block);
    let &[state, time, values, table, room] = code.block_params(block) else { return None };

    let mut writer = Writer {
        code,
        pointer,
        state,
        values,
        table,
        room,
        angle_to_point,
        pair_to_number,
        registers: Vec::with_capacity(tape.registers()),
        once: tape.rounds_once(),
    };
    for place in 0..tape.inputs().checked_sub(1)? {
        writer.registers.push(Operand::Input(offset(place)?));
    }
    writer.registers.push(Operand::Computed(time));
    for (place, constant) in tape.rounded().iter().enumerate() {
        writer.registers.push(Operand::Constant(*constant, offset(place)?));
    }
    let given = writer.registers.len();
    for kept in
        pieces.kept.iter().zip(&pieces.made_in).take_while(|(_, made_in)| **made_in < piece).map(|(kept, _)| *kept)
    {
        writer.registers.push(kept.map_or(Some(Operand::Gone), |place| offset(place).map(Operand::Kept))?);
    }
    for step in &tape.steps()[pieces.ranges[piece].clone()] {
        let first = writer.registers.len();
        writer.step(*step);
        for made in first..writer.registers.len() {
            writer.keep(made, pieces.kept[made - given])?;
        }
    }
    let is_last = piece + 1 == pieces.ranges.len();
    let is_mine =
        |register: Register| place(register, given).map_or(is_last, |computed| pieces.made_in[computed] == piece);
    let mine = tape.results().iter().copied().enumerate().filter(|(_, register)| is_mine(*register));
    writer.results(&mine.collect::<Vec<_>>())?;
    let Writer { mut code, .. } = writer;
    code.ins().return_(&[]);
    code.finalize();
    let compiled = context.compile(&**isa, &mut ControlPlane::default()).ok()?;
    // relocations are not supported; this code has none
    if !compiled.buffer.relocs().is_empty() {
        return None;
    }
    let frame = compiled.buffer.frame_layout()?.frame_to_fp_offset;
    Some(Written { instructions: compiled.code_buffer().to_vec(), frame })
}

/// The location of a number of a tape.
#[derive(Clone, Copy)]
enum Operand {
    /// An input: its offset from the first, in bytes.
    Input(i32),
    /// A constant: its value, and its offset in the table in bytes.
    Constant(f64, i32),
    Computed(Value),
    /// Computed by an earlier piece: its offset in the buffer in bytes.
    Kept(i32),
    /// Computed by an earlier piece, and read by no later one.
    Gone,
}

struct Writer<'a> {
    code: FunctionBuilder<'a>,
    pointer: ir::Type,
    state: Value,
    values: Value,
    table: Value,
    room: Value,
    angle_to_point: SigRef,
    pair_to_number: SigRef,
    registers: Vec<Operand>,
    once: bool,
}

impl Writer<'_> {
    /// Reads a number for one operation. Memory is read where it is used, so that the code generator can fold or merge
    /// loads; early loads would displace computed values from registers.
    fn read(&mut self, register: Register) -> Value {
        let code = self.code.ins();
        match self.registers[register as usize] {
            Operand::Input(offset) => code.load(types::F64, MEMORY, self.state, offset),
            Operand::Constant(constant, _) => code.f64const(constant),
            Operand::Computed(value) => value,
            Operand::Kept(offset) => code.load(types::F64, MEMORY, self.room, offset),
            Operand::Gone => unreachable!("a register that a later piece reads is kept"),
        }
    }

    /// Writes a value that later pieces read.
    fn keep(&mut self, made: usize, kept: Option<usize>) -> Option<()> {
        if let (Some(kept), Operand::Computed(value)) = (kept, self.registers[made]) {
            self.code.ins().store(KEPT, value, self.room, offset(kept)?);
        }
        Some(())
    }

    /// Two operands of a commutative operation. The second may come from memory; a constant as the first needs two
    /// instructions.
    fn either_way(&mut self, a: Register, b: Register) -> [Value; 2] {
        let rank = |register: Register| match self.registers[register as usize] {
            Operand::Computed(_) => 0,
            Operand::Input(_) | Operand::Kept(_) | Operand::Gone => 1,
            Operand::Constant(..) => 2,
        };
        let (a, b) = if rank(b) < rank(a) { (b, a) } else { (a, b) };
        [a, b].map(|register| self.read(register))
    }

    /// The two factors of a product within a sum: a constant is there an operand from the table, or needs two
    /// instructions.
    fn factors(&mut self, [a, b]: [Register; 2]) -> [Value; 2] {
        let known = [a, b].map(|register| match self.registers[register as usize] {
            Operand::Constant(_, offset) => Some(offset),
            _ => None,
        });
        match known {
            [Some(offset), None] => [self.read(b), self.code.ins().load(types::F64, MEMORY, self.table, offset)],
            [None, Some(offset)] => [self.read(a), self.code.ins().load(types::F64, MEMORY, self.table, offset)],
            _ => self.either_way(a, b),
        }
    }

    fn step(&mut self, step: Operation) {
        let result = match step {
            Operation::Sum(a, b) => {
                let [a, b] = self.either_way(a, b);
                self.code.ins().fadd(a, b)
            }
            Operation::Product(a, b) | Operation::Multiple(a, b) => {
                let [a, b] = self.either_way(a, b);
                self.code.ins().fmul(a, b)
            }
            Operation::Difference(a, b) => {
                let [a, b] = [a, b].map(|register| self.read(register));
                self.code.ins().fsub(a, b)
            }
            Operation::Quotient(a, b) | Operation::Part(a, b) => {
                let [a, b] = [a, b].map(|register| self.read(register));
                self.code.ins().fdiv(a, b)
            }
            Operation::Negation(a) => {
                let a = self.read(a);
                self.code.ins().fneg(a)
            }
            Operation::Root(a) => {
                let a = self.read(a);
                self.code.ins().sqrt(a)
            }
            Operation::Elementary(function, a, b) => self.elementary(function, a, b),
            Operation::Circle(a) => return self.circle(a),
            Operation::ProductAnd(product, other) => {
                let ([a, b], other) = (self.factors(product), self.read(other));
                self.code.ins().fma(a, b, other)
            }
            Operation::ProductLess(product, other) => {
                let ([a, b], other) = (self.factors(product), self.read(other));
                let less = self.code.ins().fneg(other);
                self.code.ins().fma(a, b, less)
            }
            Operation::LessProduct(product, other) => {
                let ([first, second], other) = (self.factors(product), self.read(other));
                let less = self.code.ins().fneg(first);
                self.code.ins().fma(less, second, other)
            }
        };
        self.registers.push(Operand::Computed(result));
    }

    /// Calls an elementary function.
    fn elementary(&mut self, function: Elementary, a: Register, b: Register) -> Value {
        let [a, b] = [a, b].map(|register| self.read(register));
        let address = match function {
            Elementary::Exp => exp as *const (),
            Elementary::Ln => ln as *const (),
            Elementary::Tanh => tanh as *const (),
            Elementary::Atan2 => atan2 as *const (),
        };
        let function = self.code.ins().iconst(self.pointer, address as i64);
        let call = self.code.ins().call_indirect(self.pair_to_number, function, &[a, b]);
        self.code.inst_results(call)[0]
    }

    /// Calls [`circle`].
    fn circle(&mut self, angle: Register) {
        let angle = self.read(angle);
        let function = if self.once { once() } else { circle as *const () };
        let function = self.code.ins().iconst(self.pointer, function as i64);
        let call = self.code.ins().call_indirect(self.angle_to_point, function, &[angle]);
        self.registers.extend(self.code.inst_results(call).iter().copied().map(Operand::Computed));
    }

    /// Writes outputs to their places. Most outputs of a Jacobian are constants: two adjacent ones are written at once,
    /// a single one as the integer with its bits.
    fn results(&mut self, mut results: &[(usize, Register)]) -> Option<()> {
        let constant = |registers: &[Operand], register: Register| match registers[register as usize] {
            Operand::Constant(constant, _) => Some(constant.to_bits()),
            _ => None,
        };
        while let [(place, register), rest @ ..] = results {
            let one = constant(&self.registers, *register);
            let beside = rest.first().filter(|(next, _)| *next == place + 1);
            let other = beside.and_then(|(_, register)| constant(&self.registers, *register));
            let (value, numbers) = match (one, other) {
                (Some(one), Some(other)) => {
                    let both = [one.to_le_bytes(), other.to_le_bytes()].concat();
                    let both = self.code.func.dfg.constants.insert(ConstantData::from(both));
                    (self.code.ins().vconst(types::I64X2, both), 2)
                }
                (Some(one), None) => (self.code.ins().iconst(types::I64, one.cast_signed()), 1),
                _ => (self.read(*register), 1),
            };
            self.code.ins().store(TOGETHER, value, self.values, offset(*place)?);
            results = &results[numbers..];
        }
        Some(())
    }
}

/// The offset of a number in bytes.
fn offset(place: usize) -> Option<i32> {
    i32::try_from(place).ok()?.checked_mul(NUMBER)
}

/// A circle point as two numbers, returned in two registers.
#[repr(C)]
struct Point {
    cos: f64,
    sin: f64,
}

impl From<field::Circle<f64>> for Point {
    fn from(field::Circle { cos, sin }: field::Circle<f64>) -> Self {
        Point { cos, sin }
    }
}

/// Cosine and sine of an angle, by the function that the whole program uses.
extern "C" fn circle(angle: f64) -> Point {
    angle.circle().into()
}

/// As [`circle`] with fused multiply-add, for processors that have the instruction.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "fma")]
extern "C" fn circle_by_fma(angle: f64) -> Point {
    angle.circle_once().into()
}

/// As `circle_by_fma`, with bitwise equal results on any processor.
extern "C" fn circle_once(angle: f64) -> Point {
    angle.circle_once().into()
}

/// The variant of both for this processor.
fn once() -> *const () {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("fma") {
        return circle_by_fma as unsafe extern "C" fn(f64) -> Point as *const ();
    }
    circle_once as *const ()
}

/// The elementary functions, by the code that the whole program uses; functions of one argument ignore the second.
macro_rules! called {
    ($($name:ident: $function:ident),*) => {$(
        extern "C" fn $name(a: f64, b: f64) -> f64 {
            a.elementary(Elementary::$function, b)
        }
    )*};
}
called!(exp: Exp, ln: Ln, tanh: Tanh, atan2: Atan2);
